#include "solvers/newton.hpp"

#include <NOX.H>
#include <NOX_Direction_Generic.H>
#include <NOX_Direction_UserDefinedFactory.H>
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

  NOX::Abstract::Vector& init(double value) override {
    values.setConstant(value);
    return *this;
  }
  NOX::Abstract::Vector& random(bool, int) override {
    values.setRandom();
    return *this;
  }
  NOX::Abstract::Vector& abs(const NOX::Abstract::Vector& y) override {
    values = of(y).cwiseAbs();
    return *this;
  }
  NOX::Abstract::Vector& operator=(const NOX::Abstract::Vector& y) override {
    values = of(y);
    return *this;
  }
  NOX::Abstract::Vector& reciprocal(const NOX::Abstract::Vector& y) override {
    values = of(y).cwiseInverse();
    return *this;
  }
  NOX::Abstract::Vector& scale(double factor) override {
    values *= factor;
    return *this;
  }
  NOX::Abstract::Vector& scale(const NOX::Abstract::Vector& a) override {
    values = values.cwiseProduct(of(a));
    return *this;
  }
  NOX::Abstract::Vector& update(double alpha, const NOX::Abstract::Vector& a, double gamma) override {
    values = gamma * values + alpha * of(a);
    return *this;
  }
  NOX::Abstract::Vector& update(double alpha, const NOX::Abstract::Vector& a, double beta,
                                const NOX::Abstract::Vector& b, double gamma) override {
    values = gamma * values + alpha * of(a) + beta * of(b);
    return *this;
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
};

// An iterate with its residual.
class NoxGroup final : public NOX::Abstract::Group {
 public:
  explicit NoxGroup(NonlinearSystem& system) : system_{&system}, x_{system.size()}, residual_{system.size()} {}

  NoxGroup& operator=(const NoxGroup&) = delete;

  NonlinearSystem& system() const { return *system_; }
  const moat::Vector& x() const { return x_.values; }
  const moat::Vector& residual() const { return residual_.values; }

  NOX::Abstract::Group& operator=(const NOX::Abstract::Group& source) override {
    const auto& other = static_cast<const NoxGroup&>(source);
    x_.values = other.x_.values;
    has_residual_ = other.has_residual_;
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
    return has_residual_ ? Ok : Failed;
  }
  bool isF() const override { return has_residual_; }
  const NOX::Abstract::Vector& getX() const override { return x_; }
  const NOX::Abstract::Vector& getF() const override { return residual_; }
  double getNormF() const override { return residual_.values.norm(); }
  const NOX::Abstract::Vector& getGradient() const override { throw std::logic_error{"NoxGroup: no gradient"}; }
  const NOX::Abstract::Vector& getNewton() const override { throw std::logic_error{"NoxGroup: no stored direction"}; }
  Teuchos::RCP<const NOX::Abstract::Vector> getXPtr() const override { return Teuchos::rcpFromRef(x_); }
  Teuchos::RCP<const NOX::Abstract::Vector> getFPtr() const override { return Teuchos::rcpFromRef(residual_); }
  Teuchos::RCP<const NOX::Abstract::Vector> getGradientPtr() const override { return Teuchos::null; }
  Teuchos::RCP<const NOX::Abstract::Vector> getNewtonPtr() const override { return Teuchos::null; }
  Teuchos::RCP<NOX::Abstract::Group> clone(NOX::CopyType type) const override {
    auto copy = Teuchos::rcp(new NoxGroup(*system_));
    if (type == NOX::DeepCopy) static_cast<NOX::Abstract::Group&>(*copy) = *this;
    return copy;
  }

 private:
  NonlinearSystem* system_;
  NoxVector x_, residual_;
  bool has_residual_ = false;
};

// The system computes the Newton direction itself: NOX's own class looks up parameters by name at every iteration.
class NewtonDirection final : public NOX::Direction::Generic {
 public:
  bool reset(const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) override { return true; }
  bool compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group, const NOX::Solver::Generic&) override {
    auto& iterate = static_cast<NoxGroup&>(group);
    return iterate.computeF() == NOX::Abstract::Group::Ok &&
           iterate.system().compute_direction(iterate.residual(), NoxVector::of(direction));
  }
};

class NewtonDirectionFactory final : public NOX::Direction::UserDefinedFactory {
 public:
  Teuchos::RCP<NOX::Direction::Generic> buildDirection(const Teuchos::RCP<NOX::GlobalData>&,
                                                       Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new NewtonDirection);
  }
};

// Converged when all rows balance (ForceBalance). Failed when a residual is not a number, or after the largest number
// of iterations.
class ForceBalanceTest final : public NOX::StatusTest::Generic {
 public:
  explicit ForceBalanceTest(NewtonOptions options) : options_{options}, balance_{options.tolerance} {}

  NewtonReport report;
  int least_iterations = 1;

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override {
    const auto& iterate = static_cast<const NoxGroup&>(solver.getSolutionGroup());
    const WorstRow worst = iterate.isF() ? ForceBalance::worst_row(iterate.residual(), iterate.system())
                                         : ForceBalance::no_number(iterate.residual());
    const int iterations = solver.getNumIterations();
    set_report(worst, iterations,
               iterations >= least_iterations && balance_.holds(worst, iterate.residual(), iterate.system()));
    if (report.converged)
      status_ = NOX::StatusTest::Converged;
    else
      status_ = std::isnan(report.residual) || iterations >= options_.max_iterations ? NOX::StatusTest::Failed
                                                                                     : NOX::StatusTest::Unconverged;
    return status_;
  }
  // The residual is not a number, or could not be computed.
  void report_no_number(const moat::Vector& residual) {
    set_report(ForceBalance::no_number(residual), report.iterations, false);
  }

  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream << "force balance"; }

 private:
  void set_report(const WorstRow& worst, int iterations, bool converged) {
    report = {converged, iterations, worst.residual, worst.degree_of_freedom};
  }

  NewtonOptions options_;
  ForceBalance balance_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

Teuchos::RCP<Teuchos::ParameterList> solver_parameters() {
  auto list = Teuchos::rcp(new Teuchos::ParameterList);
  list->set("Nonlinear Solver", "Line Search Based");
  // NOX prints failures for every value of "Output Information"; here a failure is a result. Both settings are needed:
  // formatting the progress of every iteration into a stream that drops it takes more time than the iteration.
  list->sublist("Printing").set("Output Information", static_cast<int>(NOX::Utils::Error));
  list->sublist("Printing")
      .set("Output Stream", Teuchos::RCP<std::ostream>{Teuchos::rcp(new Teuchos::oblackholestream)});
  list->sublist("Printing")
      .set("Error Stream", Teuchos::RCP<std::ostream>{Teuchos::rcp(new Teuchos::oblackholestream)});
  auto& direction = list->sublist("Direction");
  direction.set("Method", "User Defined");
  Teuchos::RCP<NOX::Direction::UserDefinedFactory> factory = Teuchos::rcp(new NewtonDirectionFactory);
  direction.set("User Defined Direction Factory", factory);
  list->sublist("Line Search").set("Method", "Full Step");
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
  Nox(NonlinearSystem& system, NewtonOptions options)
      : start{system.size()},
        test{Teuchos::rcp(new ForceBalanceTest(checked(options)))},
        solver{NOX::Solver::buildSolver(Teuchos::rcp(new NoxGroup(system)), test, solver_parameters())} {}

  NoxVector start;
  Teuchos::RCP<ForceBalanceTest> test;
  Teuchos::RCP<NOX::Solver::Generic> solver;
};

NewtonSolver::NewtonSolver(NonlinearSystem& system, NewtonOptions options)
    : nox_{std::make_unique<Nox>(system, options)} {}
NewtonSolver::~NewtonSolver() = default;
NewtonSolver::NewtonSolver(NewtonSolver&&) noexcept = default;
NewtonSolver& NewtonSolver::operator=(NewtonSolver&&) noexcept = default;

NewtonReport NewtonSolver::solve(Vector& x, int least_iterations) {
  Nox& nox = *nox_;
  nox.start.values = x;
  nox.test->report = {};
  nox.test->least_iterations = least_iterations;
  try {
    nox.solver->reset(nox.start);
    while (nox.solver->step() == NOX::StatusTest::Unconverged) {
    }
  } catch (const char* nox_error) {
    // NOX throws a text where a residual or direction could not be computed. The result is a step that did not
    // converge.
    static_cast<void>(nox_error);
    nox.test->report.converged = false;
  }
  const auto& last = static_cast<const NoxGroup&>(nox.solver->getSolutionGroup());
  x = last.x();
  // NOX does not call the status test for an iterate without residual.
  if (!last.isF()) nox.test->report_no_number(last.residual());
  return nox.test->report;
}

}  // namespace moat
