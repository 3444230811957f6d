#include "solvers/newton.hpp"

#include <NOX.H>
#include <NOX_Direction_Generic.H>
#include <NOX_Direction_UserDefinedFactory.H>
#include <NOX_MeritFunction_Generic.H>
#include <Teuchos_oblackholestream.hpp>

#include <cmath>
#include <stdexcept>

#include "base/check.hpp"
#include "solvers/force_balance.hpp"

namespace moat {
namespace {

// A Vector with NOX's interface. NOX's line-search solver needs only some of its operations; all are implemented.
class NoxVector final : public NOX::Abstract::Vector {
 public:
  explicit NoxVector(int size) : values{moat::Vector::Zero(size)} {}
  // Copies are made by NOX's virtual assignment below. The implicit one would call that of NOX's class, which does not
  // exist.
  NoxVector& operator=(const NoxVector&) = delete;

  moat::Vector values;

  static const moat::Vector& of(const NOX::Abstract::Vector& vector) {
    return static_cast<const NoxVector&>(vector).values;
  }
  static moat::Vector& of(NOX::Abstract::Vector& vector) { return static_cast<NoxVector&>(vector).values; }

  NOX::Abstract::Vector& init(double value) override { return set(moat::Vector::Constant(values.size(), value)); }
  NOX::Abstract::Vector& random(bool, int) override { return set(moat::Vector::Random(values.size())); }
  NOX::Abstract::Vector& abs(const NOX::Abstract::Vector& y) override { return set(of(y).cwiseAbs()); }
  NOX::Abstract::Vector& operator=(const NOX::Abstract::Vector& y) override { return set(of(y)); }
  NOX::Abstract::Vector& reciprocal(const NOX::Abstract::Vector& y) override { return set(of(y).cwiseInverse()); }
  NOX::Abstract::Vector& scale(double factor) override { return set(factor * values); }
  NOX::Abstract::Vector& scale(const NOX::Abstract::Vector& a) override { return set(values.cwiseProduct(of(a))); }
  NOX::Abstract::Vector& update(double alpha, const NOX::Abstract::Vector& a, double gamma) override {
    return set(gamma * values + alpha * of(a));
  }
  NOX::Abstract::Vector& update(double alpha, const NOX::Abstract::Vector& a, double beta,
                                const NOX::Abstract::Vector& b, double gamma) override {
    return set(gamma * values + alpha * of(a) + beta * of(b));
  }
  Teuchos::RCP<NOX::Abstract::Vector> clone(NOX::CopyType type) const override {
    auto copy = Teuchos::rcp(new NoxVector(static_cast<int>(values.size())));
    if (type == NOX::DeepCopy) copy->values = values;
    return copy;
  }
  double norm(NormType type) const override {
    if (values.size() == 0) return 0.0;
    if (type == MaxNorm) return values.lpNorm<Eigen::Infinity>();
    return type == OneNorm ? values.lpNorm<1>() : values.norm();
  }
  double norm(const NOX::Abstract::Vector& weights) const override {
    return std::sqrt(of(weights).dot(values.cwiseAbs2()));
  }
  double innerProduct(const NOX::Abstract::Vector& y) const override { return values.dot(of(y)); }
  NOX::size_type length() const override { return static_cast<NOX::size_type>(values.size()); }

 private:
  template <class Expression>
  NoxVector& set(const Expression& expression) {
    values = expression;
    return *this;
  }
};

// An iterate with its residual, how far that is from its balance, and the Newton direction.
class NoxGroup final : public NOX::Abstract::Group {
 public:
  explicit NoxGroup(NonlinearSystem& system)
      : system_{&system}, x_{system.size()}, residual_{system.size()}, newton_{system.size()} {}

  NoxGroup& operator=(const NoxGroup&) = delete;

  NonlinearSystem& system() const { return *system_; }
  const moat::Vector& x() const { return x_.values; }
  const moat::Vector& residual() const { return residual_.values; }
  const WorstRow& worst_row() const { return worst_row_; }

  NOX::Abstract::Group& operator=(const NOX::Abstract::Group& source) override {
    const auto& other = static_cast<const NoxGroup&>(source);
    x_.values = other.x_.values;
    has_residual_ = other.has_residual_;
    worst_row_ = other.worst_row_;
    if (has_residual_) residual_.values = other.residual_.values;
    return *this;
  }
  void setX(const NOX::Abstract::Vector& y) override {
    x_.values = NoxVector::of(y);
    has_residual_ = false;
  }
  void computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction, double step) override {
    x_.values = static_cast<const NoxGroup&>(from).x_.values + step * NoxVector::of(direction);
    has_residual_ = false;
  }
  ReturnType computeF() override {
    if (has_residual_) return Ok;
    has_residual_ = system_->compute_residual(x_.values, residual_.values);
    worst_row_ =
        has_residual_ ? ForceBalance::worst_row(residual_.values, *system_) : ForceBalance::no_number(residual_.values);
    return has_residual_ ? Ok : Failed;
  }
  ReturnType computeJacobian() override { return system_->compute_jacobian() ? Ok : Failed; }
  ReturnType computeNewton(Teuchos::ParameterList&) override {
    newton_.values = -residual_.values;
    system_->solve(newton_.values);
    return Ok;
  }
  bool isF() const override { return has_residual_; }
  const NOX::Abstract::Vector& getX() const override { return x_; }
  const NOX::Abstract::Vector& getF() const override { return residual_; }
  double getNormF() const override { return residual_.values.norm(); }
  const NOX::Abstract::Vector& getGradient() const override { throw std::logic_error{"NoxGroup: no gradient"}; }
  const NOX::Abstract::Vector& getNewton() const override { return newton_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getXPtr() const override { return Teuchos::rcpFromRef(x_); }
  Teuchos::RCP<const NOX::Abstract::Vector> getFPtr() const override { return Teuchos::rcpFromRef(residual_); }
  Teuchos::RCP<const NOX::Abstract::Vector> getGradientPtr() const override { return Teuchos::null; }
  Teuchos::RCP<const NOX::Abstract::Vector> getNewtonPtr() const override { return Teuchos::rcpFromRef(newton_); }
  Teuchos::RCP<NOX::Abstract::Group> clone(NOX::CopyType type) const override {
    auto copy = Teuchos::rcp(new NoxGroup(*system_));
    if (type == NOX::DeepCopy) static_cast<NOX::Abstract::Group&>(*copy) = *this;
    return copy;
  }

 private:
  NonlinearSystem* system_;
  NoxVector x_, residual_, newton_;
  WorstRow worst_row_;
  bool has_residual_ = false;
};

// NOX's own class for this direction does the same, and looks up parameters by name at every iteration.
class NewtonDirection final : public NOX::Direction::Generic {
 public:
  bool reset(const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) override { return true; }
  bool compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group, const NOX::Solver::Generic&) override {
    const auto ok = NOX::Abstract::Group::Ok;
    if (group.computeF() != ok || group.computeJacobian() != ok || group.computeNewton(no_parameters_) != ok)
      return false;
    direction = group.getNewton();
    return true;
  }

 private:
  Teuchos::ParameterList no_parameters_;
};

class NewtonDirectionFactory final : public NOX::Direction::UserDefinedFactory {
 public:
  Teuchos::RCP<NOX::Direction::Generic> buildDirection(const Teuchos::RCP<NOX::GlobalData>&,
                                                       Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new NewtonDirection);
  }
};

// A line search compares iterates by the number that the test of convergence judges.
class WorstRowMerit final : public NOX::MeritFunction::Generic {
 public:
  double computef(const NOX::Abstract::Group& group) const override {
    return static_cast<const NoxGroup&>(group).worst_row().residual;
  }
  void computeGradient(const NOX::Abstract::Group&, NOX::Abstract::Vector&) const override { refuse(); }
  double computeSlope(const NOX::Abstract::Vector&, const NOX::Abstract::Group&) const override { refuse(); }
  double computeQuadraticModel(const NOX::Abstract::Vector&, const NOX::Abstract::Group&) const override { refuse(); }
  void computeQuadraticMinimizer(const NOX::Abstract::Group&, NOX::Abstract::Vector&) const override { refuse(); }
  const std::string& name() const override { return name_; }

 private:
  [[noreturn]] static void refuse() { throw std::logic_error{"WorstRowMerit: it has no derivatives"}; }
  std::string name_ = "worst row";
};

// Converged when all rows balance, after one iteration at least.
class ForceBalanceTest final : public NOX::StatusTest::Generic {
 public:
  explicit ForceBalanceTest(double tolerance) : balance_{tolerance} {}

  ForceBalance& balance() { return balance_; }
  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override {
    const auto& iterate = static_cast<const NoxGroup&>(solver.getSolutionGroup());
    const bool balances = solver.getNumIterations() > 0 && iterate.isF() &&
                          balance_.holds(iterate.worst_row(), iterate.residual(), iterate.system());
    return status_ = balances ? NOX::StatusTest::Converged : NOX::StatusTest::Unconverged;
  }
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream << "force balance"; }

 private:
  ForceBalance balance_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

// The first test that has an answer decides: a last iterate that balances has converged.
Teuchos::RCP<NOX::StatusTest::Generic> status_tests(const NewtonOptions& options,
                                                    const Teuchos::RCP<ForceBalanceTest>& balance) {
  auto tests = Teuchos::rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR));
  tests->addStatusTest(Teuchos::rcp(new NOX::StatusTest::FiniteValue));
  tests->addStatusTest(balance);
  tests->addStatusTest(Teuchos::rcp(new NOX::StatusTest::MaxIters(options.max_iterations)));
  return tests;
}

Teuchos::RCP<Teuchos::ParameterList> solver_parameters(LineSearch line_search) {
  auto list = Teuchos::rcp(new Teuchos::ParameterList);
  list->set("Nonlinear Solver", "Line Search Based");
  // NOX prints failures for every value of "Output Information"; here a failure is a result. Both settings are needed:
  // formatting the progress of every iteration into a stream that drops it takes more time than the iteration.
  const Teuchos::RCP<std::ostream> nowhere = Teuchos::rcp(new Teuchos::oblackholestream);
  auto& printing = list->sublist("Printing");
  printing.set("Output Information", static_cast<int>(NOX::Utils::Error));
  printing.set("Output Stream", nowhere).set("Error Stream", nowhere);
  auto& direction = list->sublist("Direction");
  direction.set("Method", "User Defined");
  const Teuchos::RCP<NOX::Direction::UserDefinedFactory> factory = Teuchos::rcp(new NewtonDirectionFactory);
  direction.set("User Defined Direction Factory", factory);
  auto& search = list->sublist("Line Search");
  search.set("Method", line_search == LineSearch::full_step ? "Full Step" : "Backtrack");
  // Ten halvings; a direction that needs more leads nowhere.
  search.sublist("Backtrack").set("Minimum Step", 1e-3);
  const Teuchos::RCP<NOX::MeritFunction::Generic> merit = Teuchos::rcp(new WorstRowMerit);
  list->sublist("Solver Options").set("User Defined Merit Function", merit);
  return list;
}

NewtonOptions checked(NewtonOptions options) {
  const Check check{"NewtonOptions", ""};
  check.that(options.tolerance > 0.0 && options.tolerance < 1.0, "tolerance", options.tolerance, "1", "> 0 and < 1",
             "1e-10 is the default.");
  check.that(options.max_iterations >= 1, "max_iterations", options.max_iterations, "1", ">= 1");
  return options;
}

}  // namespace

struct NewtonSolver::Nox {
  Nox(NonlinearSystem& system, const NewtonOptions& wanted)
      : options{checked(wanted)},
        start{system.size()},
        group{Teuchos::rcp(new NoxGroup(system))},
        balance{Teuchos::rcp(new ForceBalanceTest(options.tolerance))},
        tests{status_tests(options, balance)} {}

  // Starts from `start`. The number of iterations is that of this call.
  NewtonReport solve(LineSearch line_search) {
    Teuchos::RCP<NOX::Solver::Generic>& solver = line_search == LineSearch::full_step ? full_step : backtrack;
    if (solver.is_null()) solver = NOX::Solver::buildSolver(group, tests, solver_parameters(line_search));
    auto status = NOX::StatusTest::Unconverged;
    try {
      solver->reset(start);
      // NOX's solve() is this loop, and writes its results into lists by name.
      while (status == NOX::StatusTest::Unconverged) status = solver->step();
    } catch (const char* nox_error) {
      // NOX throws a text where a residual could not be computed. The result is a step that did not converge.
      static_cast<void>(nox_error);
      status = NOX::StatusTest::Failed;
    }
    const WorstRow& worst = group->worst_row();
    return {status == NOX::StatusTest::Converged, solver->getNumIterations(), worst.residual, worst.degree_of_freedom};
  }

  NewtonOptions options;
  NoxVector start;
  Teuchos::RCP<NoxGroup> group;
  Teuchos::RCP<ForceBalanceTest> balance;
  Teuchos::RCP<NOX::StatusTest::Generic> tests;
  Teuchos::RCP<NOX::Solver::Generic> full_step, backtrack;  // made when they are first needed
};

NewtonSolver::NewtonSolver(NonlinearSystem& system, NewtonOptions options)
    : nox_{std::make_unique<Nox>(system, options)} {}
NewtonSolver::~NewtonSolver() = default;
NewtonSolver::NewtonSolver(NewtonSolver&&) noexcept = default;
NewtonSolver& NewtonSolver::operator=(NewtonSolver&&) noexcept = default;

void NewtonSolver::archive(StateArchive& archive) { archive(nox_->balance->balance()); }

NewtonReport NewtonSolver::solve(Vector& x) {
  Nox& nox = *nox_;
  nox.start.values = x;
  NewtonReport report = nox.solve(nox.options.line_search);
  if (!report.converged && nox.options.line_search == LineSearch::full_step) {
    const int before = report.iterations;
    report = nox.solve(LineSearch::backtrack);
    report.iterations += before;
  }
  x = nox.group->x();
  return report;
}

}  // namespace moat
