// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_texts.h"

#include <algorithm>

#include "ui/help/help_context.h"

namespace kerf::ui {

// Shop words first; the formula comes with a second touch.
std::vector<HelpText> helpTexts() {
    std::vector<HelpText> texts = buttonTexts();
    const std::vector<HelpText> others{
        {"holdAll", Help::tr("HOLD ALL"),
         Help::tr("Takes every loop off within one cycle: the last offset stays, the feed is at or below the "
                  "programmed one. The machine goes on. It is no emergency stop."),
         QStringLiteral("")},
        {"alarmBar", Help::tr("Bottom line"),
         Help::tr("The first alarm that nobody has seen yet. Show opens the page with its cause, what follows from it "
                  "and what to do. A sentence about the last touch stands here for ten seconds."),
         QStringLiteral("")},
        {"machineStrip", Help::tr("Machine strip"),
         Help::tr("What the machine does now: program, spindle speed, feed, the knob at the control, cutting force, "
                  "parts with this tool, time to go. Grey is a figure that is not fresh. Touch the strip for tools and "
                  "their life."),
         QStringLiteral("")},
        {"topLine", Help::tr("Header"),
         Help::tr("Machine, part type, lot and part; whether the machine is connected; who is signed on; language and "
                  "settings."),
         QStringLiteral("")},
        {"page:overview", Help::tr("Overview"),
         Help::tr("One card for each loop of this machine: its lamp, one sentence, the figure that matters and its "
                  "course. Made to be read from three metres; touch a card for its page."),
         QStringLiteral("")},
        {"page:boring", Help::tr("Boring"),
         Help::tr("Each bore that is measured teaches how this tool bends. From that the feed along the next bore is "
                  "chosen so that it comes out at the target at every depth."),
         QStringLiteral("ln d = ln C + α ln f + β ln L"),
         QStringLiteral(
             "C.-W. Lee, “Adaptive control of CNC boring machine by application of the variance perturbation "
             "method”, 1983")},
        {"boringBoreChart", Help::tr("Bores against the tolerance"),
         Help::tr(
             "Measured diameters of the last 25 parts, one curve for each depth, between the limits of the recipe. The "
             "diamond with its bar is what the next part should become. A cross is a bore outside its limits."),
         QStringLiteral("")},
        {"boringFeedPanel", Help::tr("Feed along the bore"),
         Help::tr("The schedule of the part in the machine (dashed), what is really cut, and the part before in grey. "
                  "Deeper the bar bends more, so the feed falls."),
         QStringLiteral("f(L) = (d0 / (C L^β))^(1/α)")},
        {"boringNextPart", Help::tr("Next part"),
         Help::tr("Diameters to be expected with the schedule shown, with their 95 % interval, and why the schedule "
                  "has changed. Under control it is used by itself; advising, a person accepts it."),
         QStringLiteral("interval: ±1.96 √(h P hᵀ + σ²)")},
        {"boringEstimatePanel", Help::tr("What has been learnt"),
         Help::tr("The three constants of the law of bending and how sure they are. The band narrows with every bore; "
                  "a jump means another insert, tool or material."),
         QStringLiteral("ln d = ln C + α ln f + β ln L, Kalman filter")},
        {"boringEntry", Help::tr("Entering a bore"),
         Help::tr("The bore that waits for its diameter. Type the last two figures or the whole diameter and press "
                  "Enter, press Gauge, or use a hand gauge. What is not plausible is asked about first."),
         QStringLiteral("")},
        {"page:milling", Help::tr("Milling"),
         Help::tr("The feed follows the cutting force: where the blank has more stock it slows down, where it has less "
                  "it hurries. The force stays even, so the wall bends evenly."),
         QStringLiteral("F = C b lᵐ,  feed ← (F_ref / (C b))^(1/m)"),
         QStringLiteral("J.-H. Oh, C.-Y. Jeong, “A Study on the Improvement of Surface Waviness by Cutting Force "
                        "Control”, 1987")},
        {"millingLive", Help::tr("Force and feed"),
         Help::tr("The force averaged over a revolution against its reference (dashed) and the overload limit; below, "
                  "the feed that is really made."),
         QStringLiteral("")},
        {"millingWall", Help::tr("Wall deviation"),
         Help::tr("How far the wall stands from its place along the path, as the force tells it. Waviness is what is "
                  "left when the mean is taken off."),
         QStringLiteral("y = F / k")},
        {"millingTool", Help::tr("Tool and wear"),
         Help::tr("The cutting stiffness of each part since the tool was new. Wear makes it rise; at the line it is "
                  "announced."),
         QStringLiteral("rise of ln(C b)")},
        {"millingControl", Help::tr("Milling control"),
         Help::tr("Off, advise or control. Advising, the cut is made at the planned feed and the page says what "
                  "control would have done, and what it would have saved."),
         QStringLiteral("")},
        {"page:turning", Help::tr("Turning"),
         Help::tr("The cutting force shows how deep the tool really is. A fast trim moves the tool against the "
                  "disturbance, so the face becomes flatter than the machine alone makes it."),
         QStringLiteral("P(z) = (b₀ + b₁ z⁻¹) / (1 − a₁ z⁻¹)"),
         QStringLiteral("S. Jeong, S. Kim, “Admittance Model-Based Nanodynamic Control of Diamond Turning Machine”")},
        {"turningSpectrum", Help::tr("Spectrum"),
         Help::tr("What the disturbance consists of. A named line is a frequency that the law has found and cancels, "
                  "or would cancel."),
         QStringLiteral("")},
        {"turningMargins", Help::tr("Margins"),
         Help::tr("How much the loop may be wrong about the process before it begins to ring: gain, phase, delay. "
                  "Below the line the law is made milder."),
         QStringLiteral("modulus margin: min |1 + L(jω)|")},
        {"turningSurface", Help::tr("Surface"),
         Help::tr("The surface as it is predicted: with the trim, and what it would be without. Root mean square and "
                  "peak to valley of the last whole revolution."),
         QStringLiteral("")},
        {"page:thermal", Help::tr("Thermal"),
         Help::tr("A warm machine grows, and the work origin moves. From the temperatures the model says how far, and "
                  "the origin is shifted back."),
         QStringLiteral("δ(t) = m(t) + g m(t) + xᵀγ + zᵀδ + b + e(t)"),
         QStringLiteral("J.-Y. Ahn, S.-C. Chung, “Modeling and Compensatory Control of Thermal Error for the Machine "
                        "Origin of Machine Tools”")},
        {"thermalOffsets", Help::tr("Drift of the origin"),
         Help::tr("How far the origin has gone in each axis since the temperatures to count from were taken, and the "
                  "interval in which it is with 95 %. Wider than the part allows: measure."),
         QStringLiteral("")},
        {"thermalDrawing", Help::tr("Thermocouples"),
         Help::tr("Where each one sits and what it reads. One that does not agree with its neighbours is left out and "
                  "named; the interval becomes wider."),
         QStringLiteral("")},
        {"page:tapping", Help::tr("Tapping"),
         Help::tr("Spindle and Z must keep step, or the thread is cut too wide. Kerf tries gains in the air, proposes "
                  "better ones, and learns a trim from tap to tap."),
         QStringLiteral("SAEC = Σ |E_r|"),
         QStringLiteral("J. Choi, W. Yoo, “Auto fitting of motor gains for high speed tapping”")},
        {"tappingContourChart", Help::tr("Error along the thread"),
         Help::tr("How far Z is from where the spindle says it should be, over the revolutions in and out, in the band "
                  "of the thread's class. Now against the first tap."),
         QStringLiteral("E_r = z − pitch · revolutions")},
        {"tappingGains", Help::tr("Gains"),
         Help::tr("The drive's gains now, the next that are proposed, and the range that was found safe in the air. "
                  "Nothing outside of it is ever tried."),
         QStringLiteral("")},
        {"tappingActions", Help::tr("What can be done"),
         Help::tr("An air tap touches nothing. A tuning tries some gains and keeps the best. A tap that stands in the "
                  "hole is turned out in sync from here, never jogged."),
         QStringLiteral("")},
        {"page:quality", Help::tr("Quality"),
         Help::tr("Whether the process is in control, and what drives it. Signals are about the error against the "
                  "law's prediction: the raw diameter is moved by the controller itself."),
         QStringLiteral("")},
        {"qualityIndices", Help::tr("Indices"),
         Help::tr("How well the lot fits its tolerance. They are shown only where the whole lot is steady: an index of "
                  "a process that moves says nothing."),
         QStringLiteral("Ppk = min(USL − x̄, x̄ − LSL) / 3s")},
        {"page:parts", Help::tr("Parts"),
         Help::tr("Every part of every process, newest first, with its figures and its verdict. Search by serial "
                  "number, lot or part type; touch a row for its details, report and corrections."),
         QStringLiteral("")},
        {"page:shift", Help::tr("Shift"),
         Help::tr("What is stored between two handovers: parts with verdicts, pauses longer than three minutes and "
                  "why, changes with names, alarms and notes. Handing over signs it and begins the next shift."),
         QStringLiteral("")},
        {"shiftSaving", Help::tr("What was saved"),
         Help::tr(
             "Milled parts: the time at the planned feed less the time really cut. Bores: how many are inside their "
             "tolerance that would be outside with the recipe's first feed, by the bending found at that time."),
         QStringLiteral("d₀ = d (f₀ / f)^α")},
        {"page:sensors", Help::tr("Sensors"),
         Help::tr("What is connected, what it reads, how old that is and where it sits. “Which one rises?”: hold a "
                  "finger on a sensor and see which channel it is."),
         QStringLiteral("")},
        {"page:alarms", Help::tr("Alarms"),
         Help::tr("Each alarm with its cause, what follows from it and what to do. Seen takes it off the bottom line; "
                  "it stays here until it is gone, then in the history."),
         QStringLiteral("")},
        {"page:diagnostics", Help::tr("Diagnostics"),
         Help::tr("How punctual the engine is, how long a cycle takes, the version, the data file and its backup. For "
                  "whoever looks after Kerf."),
         QStringLiteral("")},
    };
    texts.insert(texts.end(), others.begin(), others.end());
    return texts;
}

const HelpText* findHelp(const std::vector<HelpText>& texts, const QString& name) {
    const auto found = std::ranges::find_if(texts, [&name](const HelpText& text) {
        const QLatin1String key(text.key);
        return key.startsWith(u'*') ? name.endsWith(key.sliced(1))
               : key.endsWith(u'*') ? name.startsWith(key.chopped(1))
                                    : name == key;
    });
    return name.isEmpty() || found == texts.end() ? nullptr : &*found;
}

}  // namespace kerf::ui
