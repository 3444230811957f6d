// Writes small valid inputs for every target into folders of their names: moat_fuzz_seeds FOLDER.

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "fuzzing.hpp"
#include "network_files.hpp"
#include "saved_state.hpp"

namespace {

using namespace moat::networks;

std::filesystem::path into;

std::string joined(std::initializer_list<std::string> parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : std::string{moat::fuzz::separator}) + part;
  return text;
}

void put(const std::string& target, std::initializer_list<std::string> inputs) {
  std::filesystem::create_directories(into / target);
  int number = 0;
  for (const std::string& input : inputs)
    std::ofstream{into / target / std::to_string(++number), std::ios::binary} << input;
}

std::string saved(moat::fuzz::SavedState state) {
  moat::StateArchive archive;
  moat::StudyIdentity identity = moat::fuzz::identity_of_saved;
  archive(identity, state);
  return archive.take();
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  into = words[1];
  put("record", {knet,
                 afad,
                 cwa,
                 geonet_channel("S16W", "-12.25") + geonet_channel("S74E", "12") + geonet_channel("Down", "1"),
                 csmip_channel("360 Deg", 360, "(8f10.5)") + csmip_channel("Up", 500, "(8F10.5)"),
                 csmip_channel("90 Deg", 90, ""),
                 smc(),
                 volume_channel("L", true) + volume_channel("T", true),
                 volume_channel("L", false) + volume_channel("V", false),
                 unam,
                 cosmos(),
                 dyna,
                 peer("KJM, 90"),
                 peer("UP"),
                 "A station\nA town\nACCELERATION IN G\n 3 0.0100 NPTS, DT\n 0.1 0.2 0.3\n",
                 "# dt = 0.02 s\n0.1\n0.2\n-0.1\n",
                 "time,a\n0.00,0.1\n0.01,0.2\n0.02,-0.3\n",
                 "0 1 2\n0.01 2 3\n0.02 3 4\n",
                 "1;2;3\n4;5;6\n",
                 "Uncorrected Accelerogram Data\n" + lines(3),
                 "RAW ACCELERATION COUNTS\n" + lines(3),
                 "PEER\nA\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01 SEC\n0 1\n"});
  const std::string header = "file,channel,record,component,azimuth,unit,step,sign,columns\n",
                    text = "0.1\n0.2\n-0.1\n";
  put("record_table",
      {joined({header + "a.txt,1,Kobe,x,,gal,0.02,-1,\nb.AT2,,Kobe,y,,,,,\n", text, peer("KJM, 90")}),
       joined({"file,component,unit,step,columns\na.txt,,9.80665 m/s^2,0.01,\"x,y,z\"\nb.AT2,out,,,\n",
               "1 2 3\n4 5 6\n", peer("KJM, 90")}),
       joined({header + "a.txt,0,A,,120,g,0.01,1,series\nb.AT2,1,A,,30,,,,\n", text, peer("KJM, 90")})});
  put("matrix",
      {"2,-1\n-1,2\n", ",floor 1,floor 2\nfloor 1,2,-1\nfloor 2,-1,2\n", "2;-1\n-1;2\n",
       "12.5 -1.5 0 \n-1.5 2.5D2 -30000 \n0 -30000 9 \n",
       "%%MatrixMarket matrix coordinate real symmetric\n% kN/m\n2 2 2\n1 1 1.5\n2 1 -3e4\n",
       "%%MatrixMarket matrix coordinate integer general\n2 2 1\n2 1 7\n",
       "%%MatrixMarket matrix array real symmetric\n2 2\n1\n2\n3\n",
       "%%MatrixMarket matrix array real general\n2 2\n1\n2\n3\n4\n", "kN/m and m\n\n# a comment\n1\t2\n3\t4\n"});
  put("sap2000",
      {joined({"joint,x [m],y [m],z [m]\n1,0,0,0\n2,0,0,3.5\n",
               "Joint\tU1\tU2\tU3\tR1\tR2\tR3\n1\t0\t0\t0\t0\t0\t0\n2\t1\t2\t3\t-1\t\n-2\t\n4\t\n",
               "Row\tColumn\tValue\n1\t1\t2.5\n2\t2\t2.5\n3\t3\t9\n4\t4\t1\n1\t4\t-1e-3\n",
               "Row\tColumn\tValue\n1\t1\t1\n", "Constraint\tEquation\tCoefficient\n-1\t4\t1\n-2\t1\t0.5\n"})});
  put("table",
      {joined(
           {"name,height [m],mass [t],kx [kN/m],outline\nbase,,500,,A\nfloor 1,3.5,450,900e3,A\nfloor 2,3,450,9e5,A\n",
            "name,x [m],y [m]\nA,0,0\nA,10,0\nA,10,8\nA,0,8\n"}),
       "name,elevation [m],mass [t],inertia [t m2],x_mass [m],y_mass [m],x_rigidity [m],y_rigidity [m],ky [kN/m],"
       "k_rotation [kN m]\nground,0,1,1,0,0,0,0,1,1\nfloor 1,3.5,450,9e3,1,2,1,2,900e3,1e7\n",
       "name;x [m];y [m];type;weight [kN]\nb1;0;0;LRB;900\nb2;5;0;LRB;800\n",
       joined({"mode,period [s],ratio\n1,0.5,0.02\n2,0.1,0.05\n", "0.5,1\n1,-0.5\n"}),
       joined({"mode,eigenvalue [1/s2]\n1,150\n",
               "mode,floor,x [m],y [m],rotation [rad]\n1,1,0.5,0,0\n1,floor 2,1,0,1e-3\n"})});
  put("spectrum",
      {"# a remark\nperiod_s,sa_g\n0,0.4\n0.2,1\n1,0.6\n10,0.05\n",
       R"({"response": {"data": {"tl": 12, "multiPeriodDesignSpectrum": {"periods": [0, 0.2, 10], "ordinates": [0.4, 1, 0.1]},
          "multiPeriodMCErSpectrum": {"periods": [0, 0.2], "ordinates": [0.6, 1.5]}}}})"});
  put("quantity", {"10 cm", "0.4g", "2.95e9 N/m^1.5", "+5.", "1 GN/m", "50 %", "1,5 m", "3 kN s/m", "5 1/s", "-0.0 ms",
                   "9.81 m/s^2", "1 t", "1e400 m", "1 CM"});
  put("command_line", {"--gap\n12 cm\n--json", "--gap=0.1 m\n--out\nfolder\n--force", "--help", "--gpa\n1 cm",
                       "-h\n--\nx", "--gap\n--out", "--out=\"a b\"\nword", "-f\n-abc\n@file"});
  put("checkpoint", {saved({}), saved({.displacements = Eigen::VectorXd::Constant(3, 0.1),
                                       .loops = Eigen::MatrixXd::Identity(2, 3),
                                       .moments = {1.0, {}},
                                       .histories = {{0.0, 0.1}, {}},
                                       .places = {{"gap", {1, 2}}}})});
  put("study_file", {std::string{"\0", 1} + "0",
                     "\1"
                     "4",
                     "\2"
                     "4",
                     "\3"
                     "gap",
                     "\4"
                     "1",
                     "\5"
                     "20.0",
                     "\6"
                     "A",
                     "\7"
                     "name",
                     "\10"
                     "-1",
                     "\11"
                     "7",
                     "\12"
                     "3",
                     "\13"
                     "failed",
                     "\14"
                     "{}",
                     "\15"
                     "5",
                     "\16"
                     "a.AT2"});
  const std::string script =
      "#include <moat.hpp>\nint main() {\n  Model model;\n  add(model, Moat{.around = base,\n    .clearence = 10 * "
      "cm});\n"
      "  const ShearBuilding one{.storeys = 5, .floor_mass = 500 * kN}\n}\n";
  put("compile_errors",
      {joined({"tower.cpp:5:13: error: 'moat::Moat' has no non-static data member named 'clearence'\n    5 |     "
               ".clearence = 10 * cm});\n      |     ^\n",
               script}),
       joined({"tower.cpp: In function 'int main()':\ntower.cpp:6:60: error: could not convert "
               "'moat::operator*(500, moat::units::kN)' from 'Quantity<2,2,-4>' to 'Quantity<2,0,0>'\n",
               script}),
       joined({"tower.cpp:6:65: error: expected ',' or ';' before '}' token\n", script}),
       joined({"tower.cpp:4:6: error: no matching function for call to 'add(moat::Model&, <brace-enclosed initializer "
               "list>)'\ntower.cpp:4:6: note:   no known conversion for argument 2 from '<brace-enclosed initializer "
               "list>' to 'const moat::Moat&'\n",
               script}),
       "/usr/bin/ld: tower.o: undefined reference to `moat::f(moat::Quantity<2, 2, -4>)'\n"});
}
