#include "tests/cli/program.h"

namespace handmap {
namespace {

struct Case {
  std::string name;
  std::vector<std::string> arguments;
  std::string message;
  std::string hint;
};

void PrintTo(const Case& wrong, std::ostream* stream) { *stream << wrong.name; }

class WrongUsage : public CliTest, public testing::WithParamInterface<Case> {};

TEST_P(WrongUsage, IsToldBeforeAnyWork) {
  const Case& wrong = GetParam();
  expectFailed(run(wrong.arguments), 1,
               "handmap-cli: error: " + wrong.message + "\n" +
                   (wrong.hint.empty() ? "" : "hint: " + wrong.hint + "\n"));
}

/// A run that would work but for `more`.
std::vector<std::string> runWith(std::vector<std::string> more) {
  more.insert(more.begin(), {"run", "--map", "row-drawn.handmap", "--recording", "rec"});
  return more;
}

std::vector<std::string> perturbWith(std::vector<std::string> more) {
  more.insert(more.begin(), {"perturb", "--map", "row-truth.handmap"});
  return more;
}

const std::string kRunHelp = "handmap-cli run --help";
const std::string kPerturbHelp = "handmap-cli perturb --help";

INSTANTIATE_TEST_SUITE_P(
    Cli, WrongUsage,
    testing::Values(
        Case{"UnknownMethod", runWith({"--method", "magic"}),
             "--method: found magic, expected handmap|paper", kRunHelp},
        Case{"UnknownSource", runWith({"--source", "smell"}),
             "--source: found smell, expected auto|images|points", kRunHelp},
        Case{"UnknownRatio", runWith({"--effective-ratio", "1"}),
             "--effective-ratio: found 1, expected to-all|to-zero", kRunHelp},
        Case{"EveryNone", runWith({"--every", "0"}),
             "--every: found 0, expected a number from 1 to 1000000", kRunHelp},
        Case{"FromBefore", runWith({"--from", "-3"}),
             "--from: found -3, expected a number from 0 to 2147483647", kRunHelp},
        Case{"ToBeforeFrom", runWith({"--from", "5", "--to", "4"}),
             "--to: found 4, expected 5 (--from) or more", ""},
        Case{"NoParticle", runWith({"--slam-particles", "0"}),
             "--slam-particles: found 0, expected a number from 1 to 100000", kRunHelp},
        Case{"NoSwarm", runWith({"--pso-particles", "none"}),
             "--pso-particles: found none, expected a number from 1 to 10000", kRunHelp},
        Case{"HalfAThread", runWith({"--threads", "0.5"}), "Could not convert: --threads = 0.5",
             kRunHelp},
        Case{"SeedBelowZero", runWith({"--seed", "-1"}),
             "--seed: found -1, expected a whole number from 0", kRunHelp},
        Case{"NoFolderForOut", runWith({"--out", "gone/refined.handmap"}),
             "gone/refined.handmap: cannot be written: no such folder", ""},
        Case{"FolderForReport", runWith({"--report", "."}), ".: cannot be written: it is a folder",
             ""},
        Case{"OutOverTheDrawing", runWith({"--out", "./row-drawn.handmap"}),
             "./row-drawn.handmap: cannot be written: it is an input, and inputs are kept", ""},
        Case{"OutTwice", runWith({"--out", "same", "--report", "./same"}),
             "./same: cannot be written: another output goes there", ""},
        Case{"SigmaNotANumber", perturbWith({"--sigma", "nan", "--out", "s.handmap"}),
             "--sigma: found nan, expected a number from 0.01 to 1000", kPerturbHelp},
        Case{"SigmaZero", perturbWith({"--sigma", "0", "--out", "s.handmap"}),
             "--sigma: found 0, expected a number from 0.01 to 1000", kPerturbHelp},
        Case{"NoSigma", perturbWith({"--out", "s.handmap"}), "--sigma is required", kPerturbHelp},
        Case{"SketchOverTruth", perturbWith({"--sigma", "1", "--out", "row-truth.handmap"}),
             "row-truth.handmap: cannot be written: it is an input, and inputs are kept", ""},
        Case{"MovingWithoutImages",
             {"simulate", "--moving", "--out", "rec"},
             "--moving requires --images",
             "handmap-cli simulate --help"},
        Case{"TooManyPixels",
             {"simulate", "--images", "--width", "100000", "--out", "rec"},
             "--width: found 100000, expected a number from 64 to 4096",
             "handmap-cli simulate --help"},
        Case{"FolderInUse",
             {"simulate", "--out", "."},
             ".: found something there, expected a new folder or an empty one",
             ""},
        Case{"TwoWorlds",
             {"simulate", "--world", "row-truth.handmap", "--scene", "campus", "--out", "rec"},
             "--world excludes --scene",
             "handmap-cli simulate --help"},
        Case{"OnlyUnknown",
             {"compare", "row-drawn.handmap", "row-truth.handmap", "--only", "N1,N7"},
             "--only: found \"N7\", expected ids of buildings of the truth",
             ""},
        Case{"FreePaper",
             {"run", "--map", "row-drawn.handmap", "--recording", "rec", "--method", "paper",
              "--free", "turn"},
             "--free: not with --method paper or --localize-only",
             ""},
        Case{"GivenPosesLive",
             {"run", "--map", "row-drawn.handmap", "--virtual-rig", "--given-poses", "p.tum"},
             "--given-poses: not with a live robot; run its recording",
             ""},
        Case{"ClassOfNoNetwork",
             {"run", "--map", "row-drawn.handmap", "--recording", "rec", "--building-class", "2"},
             "--building-class: only with --model NAME.onnx",
             ""},
        Case{"ViewOfACamera",
             {"simulate", "--images", "--view", "180", "--out", "rec"},
             "--view excludes --images",
             "handmap-cli simulate --help"},
        Case{"FeaturesOfALaser",
             {"simulate", "--features", "27", "--laser", "--out", "rec"},
             "--laser excludes --features",
             "handmap-cli simulate --help"},
        Case{"JoinedRays",
             {"simulate", "--joined", "40", "--out", "rec"},
             "--joined requires --features",
             "handmap-cli simulate --help"},
        Case{"HalfAStart",
             {"simulate", "--start-off", "2", "--out", "rec"},
             "--start-off: found 2, expected M,DEG from 0,0 to 100,90",
             "handmap-cli simulate --help"},
        Case{"DriftOfWords",
             {"simulate", "--drift", "5,much", "--out", "rec"},
             "--drift: found 5,much, expected PERCENT,DEG from 0,0 to 50,10",
             "handmap-cli simulate --help"},
        Case{"TrajectoryAlone",
             {"compare", "row-drawn.handmap", "row-truth.handmap", "--trajectory", "t.tum"},
             "--trajectory requires --truth",
             "handmap-cli compare --help"},
        Case{"NothingToValidate", {"validate"}, "path is required", "handmap-cli validate --help"}),
    [](const testing::TestParamInfo<Case>& tested) { return tested.param.name; });

}  // namespace
}  // namespace handmap
