// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "ui/help/help_texts.h"

namespace kerf::ui {
namespace {

struct Help {
    Q_DECLARE_TR_FUNCTIONS(Help)
};

HelpText about(const char* key, const QString& title, const QString& words) {
    return {key, title, words, QString()};
}

}  // namespace

std::vector<HelpText> buttonTexts() {
    return {
        about("*ModeOff", Help::tr("Off"),
              Help::tr(
                  "The loop has no influence: the machine runs as it was programmed. What is measured is still kept.")),
        about("*ModeAdvise", Help::tr("Advise"),
              Help::tr("The loop computes and shows what it would do, and does nothing. The way to get to know it.")),
        about("*ModeControl", Help::tr("Control"),
              Help::tr("The loop acts on the machine, within its limits. HOLD ALL takes it off at once.")),
        about("*Start", Help::tr("Start"),
              Help::tr(
                  "Starts the program of the next part, where the control allows it. Off, it says what is missing.")),
        about("startPart", Help::tr("Start part"),
              Help::tr("Starts the next part on the simulator, or on a control that allows it. Off, it says why.")),
        about(
            "releaseHold", Help::tr("Release hold"),
            Help::tr("After a look at the machine: the loops go on in the mode they had, without a jump. A stop stays "
                     "until it is released by its own button.")),
        about("feedRate", Help::tr("Feed"),
              Help::tr("How fast the axis moves now, as the control reports it. Grey: not fresh.")),
        about("partCounter", Help::tr("Parts since start"),
              Help::tr("Parts begun since this console was started, whatever process made them.")),
        about("boringAccept", Help::tr("Accept"),
              Help::tr("In advise mode: the schedule shown is what the next part shall be cut with. It is written down "
                       "with the name. In control every schedule is used by itself. Its bores are expected within the "
                       "95 % interval shown.")),
        about("boringChange", Help::tr("Tool or material changed"),
              Help::tr("Two touches after a new insert, a reground tool or another batch of material: the next bore is "
                       "expected from what such changes have brought before, with a wider interval.")),
        about("boringNextLot", Help::tr("Next lot"),
              Help::tr("This lot is complete or closed: here the next one is opened.")),
        about("boringUndo", Help::tr("Undo last"),
              Help::tr("Takes the newest diameter back. It stays in the records, with who undid it.")),
        about("boringCorrect", Help::tr("Correct"),
              Help::tr("All diameters of the lot: touch one to correct it or take it out, with a reason. Everything "
                       "after it is computed again.")),
        about("boringGauge", Help::tr("Gauge"),
              Help::tr("On the simulator: measures the bore that waits. On a machine the gauge sends by its own key.")),
        about("boringMeasureAgain", Help::tr("Measure again"),
              Help::tr("Leaves the value that was asked about and waits for another one. Nothing was stored.")),
        about("boringConfirm", Help::tr("Confirm"),
              Help::tr("The value is far from what was expected, and it is right: it is stored as confirmed.")),
        about("boringChannels", Help::tr("Channels"),
              Help::tr("Which channel of the gauge box stands for which depth. Learnt once, changed here.")),
        about("boringNextDiameter*", Help::tr("Expected diameter"),
              Help::tr("What the next part is expected to measure at this depth. 19 of 20 bores fall into the interval "
                       "beside it.")),
        about("millingForce", Help::tr("Force"), Help::tr("Mean force of the last revolution; this is what is held.")),
        about("millingRawForce", Help::tr("Force of single teeth"),
              Help::tr("Lowest and highest force since the last picture: what the tool really feels.")),
        about("millingFeed", Help::tr("Feed"), Help::tr("Feed now; under control it goes where the force wants it.")),
        about("millingStiffness", Help::tr("How the tool cuts"),
              Help::tr("How hard this tool works for its feed, as learnt from its cuts. It grows as the tool wears.")),
        about("millingNewTool", Help::tr("New tool"),
              Help::tr("Another tool is in: wear is counted anew, and what tools of its kind have taught is used.")),
        about("millingTeach", Help::tr("Teach"),
              Help::tr("Takes the mean force of the last good cut as the reference that the feed shall hold.")),
        about("millingRelease", Help::tr("Release the stop"),
              Help::tr("The feed was stopped by an overload or a broken tool. After a look at tool and work, this lets "
                       "the next cut begin; it needs a name.")),
        about("millingReference", Help::tr("Reference force"),
              Help::tr("The force that the feed holds: higher is faster, and bends the tool more.")),
        about(
            "millingMargin", Help::tr("Gain margin"),
            Help::tr(
                "How many times stronger the law could act before the force begins to swing; below two it is close.")),
        about("millingPeak", Help::tr("Peak force"), Help::tr("Highest force of this cut, of single teeth.")),
        about("millingSaved", Help::tr("Saved"),
              Help::tr("Time against the planned feed on the same path; in advise mode, what control would save.")),
        about("millingLaw*", Help::tr("Law"),
              Help::tr("How the feed is found from the force. Model is the default; the others are there to compare.")),
        about("millingSetup", Help::tr("Setup"),
              Help::tr("Tool, path, planned feed, reference and limits of the next cuts.")),
        about("millingBlank", Help::tr("Blank"),
              Help::tr("How much stands on the blank along the path, so that the feed is ready before a step comes.")),
        about("millingLog", Help::tr("Log"), Help::tr("The last cuts with force, waviness and time.")),
        about("millingTools", Help::tr("Tools"),
              Help::tr("What was learnt of tools of this kind; one can be left out, with a reason.")),
        about("turningSurfaceRms", Help::tr("Unevenness"),
              Help::tr("How far the face is from flat on average (root mean square), as predicted from the force.")),
        about("turningSurfacePv", Help::tr("Highest to lowest point"),
              Help::tr("Peak to valley of the last whole revolution, as predicted from the force.")),
        about("turningUntreatedRms", Help::tr("Without the trim"),
              Help::tr("What the unevenness would be if the trim stood still: the difference is the loop's work.")),
        about("turningGainMargin", Help::tr("Gain margin"),
              Help::tr("By how much stronger the cut may answer than it was identified before the loop rings.")),
        about("turningPhaseMargin", Help::tr("Phase margin"),
              Help::tr("By which angle the answer may come later before the loop rings.")),
        about("turningDelayMargin", Help::tr("Delay margin"),
              Help::tr("By how much time the answer may come later before the loop rings.")),
        about("turningModulusMargin", Help::tr("Modulus margin"),
              Help::tr("Smallest distance of the open loop from the point where it rings: 1 is calm, 0 rings.")),
        about("turningSetup", Help::tr("Setup"),
              Help::tr("Depth, speed and path of the next cut, and how far the trim may go.")),
        about("turningArchive", Help::tr("Archive of parts"),
              Help::tr("The parts turned so far, with surface, force and trim of each; one can be left out of what the "
                       "next begin from, with a reason.")),
        about("turningOpen", Help::tr("Open"), Help::tr("No trim: what the lathe does by itself.")),
        about("turningPaper", Help::tr("Paper"), Help::tr("The controller of the published work, for comparison.")),
        about("turningPi", Help::tr("PI"), Help::tr("A tuned PI controller, for comparison.")),
        about("turningTones", Help::tr("Tones"),
              Help::tr("The default: a broadband law, and one for each vibration it finds; none has to be named.")),
        about("tappingTune", Help::tr("Tune"),
              Help::tr("Taps in the air, then proposes gains that match spindle and Z, and says what limits them.")),
        about("tappingRecover", Help::tr("Turn out"),
              Help::tr("A tap stands in the hole: spindle and Z turn it out together.")),
        about("tappingJob", Help::tr("Job"), Help::tr("Thread, depth, speed and class of what is tapped.")),
        about("tappingTap", Help::tr("Tap"), Help::tr("One tap with the gains in force, in the work or in the air.")),
        about("tappingOneMore", Help::tr("One more"), Help::tr("One more trial before the proposal is made.")),
        about("tappingAccept", Help::tr("Accept"),
              Help::tr("The gains proposed are used from now on, and kept with your name.")),
        about("tappingRollBack", Help::tr("Roll back"), Help::tr("Back to the gains that were in force before.")),
        about("tappingAbort", Help::tr("Abort"),
              Help::tr("Turns the tap out in step with Z and goes back to the gains accepted last.")),
        about("tappingAutomatic", Help::tr("Automatic"),
              Help::tr("Trials follow each other without a touch, until a proposal is there.")),
        about("thermalDrift*", Help::tr("Drift"),
              Help::tr("How far the origin is thought to have moved since the reference, with the interval in which it "
                       "lies on 19 of 20 minutes. Measuring makes it narrow.")),
        about("thermalWarmUp", Help::tr("Warm up"),
              Help::tr("Runs the warm-up program until the drift is small enough to cut.")),
        about("thermalMeasure", Help::tr("Measure"),
              Help::tr("Measures the origin: the prediction counts on from what was measured, at once.")),
        about("thermalModel", Help::tr("Model"),
              Help::tr("Which days the model has learnt from, how well it told days it had not seen, train, go back.")),
        about("thermalHistory", Help::tr("History"), Help::tr("Every shift of the origin, with when and why.")),
        about("thermalSensors", Help::tr("Sensors"), Help::tr("Thermocouples: where each sits, and its health.")),
        about("thermalMap", Help::tr("Map"), Help::tr("How the error of the axes differs over the table.")),
        about("thermalLimits", Help::tr("Limits"), Help::tr("How far and how often the origin may be shifted.")),
        about("placeSensor", Help::tr("Place"), Help::tr("Touch the picture where this sensor sits.")),
        about("acknowledge", Help::tr("Acknowledge"),
              Help::tr(
                  "Somebody has seen this alarm; the name goes into the history. It stays until its cause is gone.")),
        about("alarmsNow", Help::tr("Now"), Help::tr("Alarms that stand now, the most urgent first.")),
        about("alarmsHistory", Help::tr("History"),
              Help::tr("All alarms, with when they came and went, and who has seen them.")),
        about("alarmExport", Help::tr("Export"),
              Help::tr("The history as shown, as a table into a folder of your choice. No file is written over.")),
        about("partsSearch", Help::tr("Search"),
              Help::tr("Part number, serial number, lot or part type; what is typed is looked for as it is typed.")),
        about("partsBad", Help::tr("Out of tolerance"), Help::tr("Only parts with rework or scrap.")),
        about("partsThisLot", Help::tr("This lot"), Help::tr("Only parts of the lot that is open.")),
        about("partsExport", Help::tr("Export"),
              Help::tr("The parts shown, as a table for Excel or programs, into a folder of your choice.")),
        about("partCorrect", Help::tr("Correct"),
              Help::tr("Another value for the diameter chosen, with a reason. The old one stays in the records.")),
        about("partVoid", Help::tr("Take out"),
              Help::tr("The diameter chosen no longer counts, with a reason. It stays in the records.")),
        about("partSerial", Help::tr("Serial"), Help::tr("Gives the part its serial number, or another one.")),
        about("partReport", Help::tr("Report"),
              Help::tr("One page about this part as PDF: diameters, tolerance, verdict, feed.")),
        about("qualityDecide", Help::tr("Out of tolerance"),
              Help::tr("What was done with parts outside their limits: reworked, scrapped, released by whom.")),
        about("qualityFiles", Help::tr("Files"),
              Help::tr("Reports of the lot, and Q-DAS files by hand or by themselves into a folder.")),
        about("qualityGauges", Help::tr("Gauges"),
              Help::tr("The register of gauges: range, due date, studies of a ring and of several people.")),
        about("qualityLimits", Help::tr("Limits"),
              Help::tr("Limits of the figures of milled, turned and tapped parts, by which they are judged.")),
        about("qualityRules", Help::tr("Rules"),
              Help::tr("Which rules of the charts are on, for page, report and alarm. Few at once: each alarms wrongly "
                       "now and then.")),
        about("qualityOlder", Help::tr("Older"), Help::tr("The parts before those shown.")),
        about("qualityNewer", Help::tr("Newer"), Help::tr("The parts after those shown.")),
        about("shiftNote", Help::tr("Leave a note"), Help::tr("A sentence for the next shift, signed with your name.")),
        about("shiftHandOver", Help::tr("Hand over"),
              Help::tr("Signs this shift; the next one begins now and reads your words first.")),
        about("shiftPdf", Help::tr("One page (PDF)"), Help::tr("The shift as it stands here, on one page.")),
        about("shiftEarlier", Help::tr("Shift before"),
              Help::tr("The shift that was handed over before the one shown.")),
        about("shiftNow", Help::tr("This shift"), Help::tr("Back to the shift that goes on.")),
        about("shiftStops", Help::tr("Stops"),
              Help::tr("Pauses of more than three minutes. Touch one and say why; two touches.")),
        about("whichOneRises", Help::tr("Which one rises?"),
              Help::tr("Warm a thermocouple with a finger: the one that rises first is named, so that its place on the "
                       "picture can be set.")),
        about("askGauge", Help::tr("Ask the gauge"), Help::tr("Asks a gauge for a reading, to see that it answers.")),
        about("backup", Help::tr("Back up all data"),
              Help::tr("A checked copy of everything in one file, made while everything goes on.")),
        about("restore", Help::tr("Restore a backup"),
              Help::tr("Puts a backup in the place of the data at the next start. What is there now is set aside. For "
                       "process engineers, with a reason.")),
        about("lots", Help::tr("Lots"), Help::tr("Open, choose or close a lot; recipes of the part types.")),
        about("operator", Help::tr("Who is there"),
              Help::tr("Sign on, sign off, people and their roles; a second person for limits.")),
        about("settings", Help::tr("Settings"), Help::tr("Language, units, light or dark, size of the text.")),
        about("language", Help::tr("Language"), Help::tr("Korean or English, at once, on all pages.")),
        about("simulationSpeed", Help::tr("Simulator"),
              Help::tr("How much faster than time the simulated machine runs. A real machine has no such button.")),
    };
}

}  // namespace kerf::ui
