// Every file that the program writes is the same in a host process with decimal commas.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/files/spindle_text.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

namespace fs = std::filesystem;

/// A German locale, made from Debian's sources; the test's folder has nothing else.
class GermanHost {
 public:
  GermanHost() {
    const std::string make =
        "localedef --no-archive -i de_DE -f UTF-8 " + folder_.file("de_DE.UTF-8") + " 2>/dev/null";
    made_ = std::system(make.c_str()) == 0;
  }
  [[nodiscard]] bool made() const { return made_; }
  /// Before a command, which then runs in it.
  [[nodiscard]] std::string prefix() const {
    const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
    return "LOCPATH=" + folder_.path().string() +
           " LC_ALL=de_DE.UTF-8 LD_PRELOAD=" + (here / "libcomma_host.so").string() + " ";
  }

 private:
  ScratchFolder folder_;
  bool made_ = false;
};

/// Numbers with many digits, so that none of them survives a comma by chance.
const std::string model = replaced(std::string(model_text), "f0 = ", "f0 = 1.2345 # ");

const std::string rig_with_scatter =
    "speed_rpm,axial_load_N,friction_torque_Nmm,std_Nmm\n"
    "1000.5,100.25,92.25,1.5\n2000,100,140.5,1.5\n4000,100,221,1.5\n8000,100,347,1.5\n"
    "1000,900,140,1.5\n2000,900,190.75,1.5\n4000,900,269,1.5\n8000,900,397.125,1.5\n";

/// By folder of the repository ($data), in the folder of the run.
const std::vector<std::string> commands{
    "new 'S 6014 C' -o new.toml",
    "solve model.toml --speed 6000.5 --axial-load 300.25",
    "solve model.toml --speed 6000.5 --axial-load 300.25 --json",
    "table model.toml --speed 0.5:9000:3000 --axial-load 100.5,300 -o t.csv --plot t.svg --json",
    "table model.toml --speed 500.5:9000:3000 --axial-load 100.5 --format plain -o t.txt",
    "table model.toml --speed 500.5:9000:3000 --axial-load 100.5 --format modelica -o t.mo",
    "calibrate model.toml rig.csv -o fitted.toml --json",
    "calibrate 'S 6014 C' -o conformity.toml --json",
    "calibrate-sensor $data/measurements/torque_weights.csv -o sensor.toml --json",
    "compare model.toml fitted.toml rig.csv --json --report page.html",
    "check model.toml rig.csv -o read.csv --json",
    "add model.toml windage --data rig.csv -o added.toml --force --json",
    "diagnose model.toml rig.csv --no-pairs --json",
    "sensitivity model.toml --speed 6000 --axial-load 300 --json",
    "displacement spindle.toml --speed 500.5:6000:1500 -o u.csv --json",
    "fit-law u.csv -o law.csv --json",
    "spindle spindle.toml --speed-profile day.csv -o day_out.csv --end-state end.json --field "
    "field.csv --json",
    "modes spindle.toml --speed 0,3000.5 -o modes.csv --shapes shapes.csv --json",
    "deflection spindle.toml --force 100.5 -o bent.csv --json",
    "step-response spindle.toml --speed 3000,4500.5 -o steps.csv --correction step.toml --json",
    "identify z.toml $data/corrections/exact/train.csv -o identified.toml --json",
    "identify bare.toml $data/corrections/ambient/train.csv --lags auto -o bank.toml --json",
    "calibrate identified.toml $data/corrections/exact/train.csv -o z_fitted.toml --json",
    "correct identified.toml $data/corrections/exact/test.csv -o z.csv --json",
    "correct identified.toml $data/corrections/exact/test.csv --learn --save learnt.toml --json",
    "export identified.toml --format python -o z.py",
    "export identified.toml --format c -o z.h",
    "export identified.toml --format csv -o z_table.csv",
    "export identified.toml --format linuxcnc -o zhal.py",
    "effects --json",
    "keys --json",
    "bearings 'S 6014 C' --json"};

/// What every command prints and all files that it writes, by name.
std::map<std::string, std::string> written(const std::string& before) {
  const ScratchFolder folder;
  folder.write("model.toml", model);
  folder.write("rig.csv", rig_with_scatter);
  folder.write("spindle.toml", shortest_spindle + "[solver]\ncells = \"coarse\"\n");
  folder.write("day.csv", "time_s,speed_rpm\n0,0\n600.5,3000.5\n1200,6000\n");
  folder.write("z.toml",
               file_text(tests::source_dir() + "/data/corrections/exact/correction.toml"));
  folder.write("bare.toml", "[correction]\ndisplacement = \"displacement_z_um\"\n");
  std::map<std::string, std::string> results;
  for (const std::string& command : commands) {
    const Result r = run_shell("cd " + folder.path().string() + "; data=" + tests::source_dir() +
                               "/data; " + before + "$raceway " + command);
    EXPECT_EQ(r.status, 0) << command << r.err;
    results[command] = fmt::format("{}\n{}\n{}", r.status, r.out, r.err);
  }
  for (const auto& entry : fs::directory_iterator(folder.path()))
    results[entry.path().filename().string()] = file_text(entry.path());
  return results;
}

TEST(Locale, AHostWithDecimalCommasChangesNoFile) {
  const GermanHost host;
  ASSERT_TRUE(host.made()) << "localedef: Debian's package locales is missing";
  // The host does what it is for.
  const std::string point =
      "python3 -c \"import locale; print(locale.localeconv()['decimal_point'])\"";
  ASSERT_EQ(run_shell(host.prefix() + point).out, ",\n");
  const auto plain = written(""), german = written(host.prefix());
  ASSERT_EQ(plain.size(), german.size());
  for (const auto& [name, text] : plain) EXPECT_EQ(german.at(name), text) << name;
}

}  // namespace
}  // namespace raceway::tests
