<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
    <context>
    <name>BoringTexts</name>
        <message>
            <source>top</source>
            <comment>depth of a bore</comment>
            <translation>top</translation>
        </message>
        <message>
            <source>middle</source>
            <comment>depth of a bore</comment>
            <translation>middle</translation>
        </message>
        <message>
            <source>bottom</source>
            <comment>depth of a bore</comment>
            <translation>bottom</translation>
        </message>
        <message>
            <source>part %1, %2</source>
            <comment>part number, depth of its bore</comment>
            <translation>part %1, %2</translation>
        </message>
        <message>
            <source>Tool reground</source>
            <translation>Tool reground</translation>
        </message>
        <message>
            <source>Other material</source>
            <translation>Other material</translation>
        </message>
        <message>
            <source>New insert</source>
            <translation>New insert</translation>
        </message>
        <message>
            <source>Below %1: %2.</source>
            <translation>Below %1: %2.</translation>
        </message>
        <message>
            <source>Above %1: %2.</source>
            <translation>Above %1: %2.</translation>
        </message>
    </context>
    <context>
    <name>FigureLimits</name>
        <message>
            <source>Limits: %1</source>
            <translation>Limits: %1</translation>
        </message>
        <message>
            <source>Limits in the recipe of %1 (%2)</source>
            <translation>Limits in the recipe of %1 (%2)</translation>
        </message>
        <message>
            <source>A figure outside its limits makes the part scrap. In the stored unit; an empty field is no limit. They hold for the parts to come: a part keeps the limits it was made under.</source>
            <translation>A figure outside its limits makes the part scrap. In the stored unit; an empty field is no limit. They hold for the parts to come: a part keeps the limits it was made under.</translation>
        </message>
        <message>
            <source>Figure</source>
            <translation>Figure</translation>
        </message>
        <message>
            <source>Lower limit</source>
            <translation>Lower limit</translation>
        </message>
        <message>
            <source>Upper limit</source>
            <translation>Upper limit</translation>
        </message>
        <message>
            <source>Reason for the change</source>
            <translation>Reason for the change</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>A limit is a number, or empty.</source>
            <translation>A limit is a number, or empty.</translation>
        </message>
        <message>
            <source>The limits stand in the recipe and hold for the parts to come.</source>
            <translation>The limits stand in the recipe and hold for the parts to come.</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Save</translation>
        </message>
        <message>
            <source>Limits of the parts</source>
            <translation>Limits of the parts</translation>
        </message>
    </context>
    <context>
    <name>FirstEngineer</name>
        <message>
            <source>The first process engineer</source>
            <translation>The first process engineer</translation>
        </message>
        <message>
            <source>This machine knows nobody yet who may change recipes, limits and roles. Until then everybody who signs on is an operator.</source>
            <translation>This machine knows nobody yet who may change recipes, limits and roles. Until then everybody who signs on is an operator.</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>PIN, %1 to %2 digits</source>
            <translation>PIN, %1 to %2 digits</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>Later</translation>
        </message>
        <message>
            <source>A name and a PIN of %1 to %2 digits are needed.</source>
            <translation>A name and a PIN of %1 to %2 digits are needed.</translation>
        </message>
        <message>
            <source>Make and sign on</source>
            <translation>Make and sign on</translation>
        </message>
    </context>
    <context>
    <name>ForceText</name>
        <message>
            <source>zero being taken</source>
            <translation>zero being taken</translation>
        </message>
        <message>
            <source>zero %1</source>
            <translation>zero %1</translation>
        </message>
        <message>
            <source>no zero</source>
            <translation>no zero</translation>
        </message>
        <message>
            <source>zero doubtful by %1</source>
            <translation>zero doubtful by %1</translation>
        </message>
        <message>
            <source>bandwidth %1</source>
            <translation>bandwidth %1</translation>
        </message>
        <message>
            <source>bandwidth not stated</source>
            <translation>bandwidth not stated</translation>
        </message>
    </context>
    <context>
    <name>Help</name>
        <message>
            <source>HOLD ALL</source>
            <translation>HOLD ALL</translation>
        </message>
        <message>
            <source>Takes every loop off within one cycle: the last offset stays, the feed is at or below the programmed one. The machine goes on. It is no emergency stop.</source>
            <translation>Takes every loop off within one cycle: the last offset stays, the feed is at or below the programmed one. The machine goes on. It is no emergency stop.</translation>
        </message>
        <message>
            <source>Bottom line</source>
            <translation>Bottom line</translation>
        </message>
        <message>
            <source>The first alarm that nobody has seen yet. Show opens the page with its cause, what follows from it and what to do. A sentence about the last touch stands here for ten seconds.</source>
            <translation>The first alarm that nobody has seen yet. Show opens the page with its cause, what follows from it and what to do. A sentence about the last touch stands here for ten seconds.</translation>
        </message>
        <message>
            <source>Machine strip</source>
            <translation>Machine strip</translation>
        </message>
        <message>
            <source>What the machine does now: program, spindle speed, feed, the knob at the control, cutting force, parts with this tool, time to go. Grey is a figure that is not fresh. Touch the strip for tools and their life.</source>
            <translation>What the machine does now: program, spindle speed, feed, the knob at the control, cutting force, parts with this tool, time to go. Grey is a figure that is not fresh. Touch the strip for tools and their life.</translation>
        </message>
        <message>
            <source>Header</source>
            <translation>Header</translation>
        </message>
        <message>
            <source>Machine, part type, lot and part; whether the machine is connected; who is signed on; language and settings.</source>
            <translation>Machine, part type, lot and part; whether the machine is connected; who is signed on; language and settings.</translation>
        </message>
        <message>
            <source>Overview</source>
            <translation>Overview</translation>
        </message>
        <message>
            <source>One card for each loop of this machine: its lamp, one sentence, the figure that matters and its course. Made to be read from three metres; touch a card for its page.</source>
            <translation>One card for each loop of this machine: its lamp, one sentence, the figure that matters and its course. Made to be read from three metres; touch a card for its page.</translation>
        </message>
        <message>
            <source>Boring</source>
            <translation>Boring</translation>
        </message>
        <message>
            <source>Each bore that is measured teaches how this tool bends. From that the feed along the next bore is chosen so that it comes out at the target at every depth.</source>
            <translation>Each bore that is measured teaches how this tool bends. From that the feed along the next bore is chosen so that it comes out at the target at every depth.</translation>
        </message>
        <message>
            <source>Bores against the tolerance</source>
            <translation>Bores against the tolerance</translation>
        </message>
        <message>
            <source>Measured diameters of the last 25 parts, one curve for each depth, between the limits of the recipe. The diamond with its bar is what the next part should become. A cross is a bore outside its limits.</source>
            <translation>Measured diameters of the last 25 parts, one curve for each depth, between the limits of the recipe. The diamond with its bar is what the next part should become. A cross is a bore outside its limits.</translation>
        </message>
        <message>
            <source>Feed along the bore</source>
            <translation>Feed along the bore</translation>
        </message>
        <message>
            <source>The schedule of the part in the machine (dashed), what is really cut, and the part before in grey. Deeper the bar bends more, so the feed falls.</source>
            <translation>The schedule of the part in the machine (dashed), what is really cut, and the part before in grey. Deeper the bar bends more, so the feed falls.</translation>
        </message>
        <message>
            <source>Next part</source>
            <translation>Next part</translation>
        </message>
        <message>
            <source>Diameters to be expected with the schedule shown, with their 95 % interval, and why the schedule has changed. Under control it is used by itself; advising, a person accepts it.</source>
            <translation>Diameters to be expected with the schedule shown, with their 95 % interval, and why the schedule has changed. Under control it is used by itself; advising, a person accepts it.</translation>
        </message>
        <message>
            <source>What has been learnt</source>
            <translation>What has been learnt</translation>
        </message>
        <message>
            <source>The three constants of the law of bending and how sure they are. The band narrows with every bore; a jump means another insert, tool or material.</source>
            <translation>The three constants of the law of bending and how sure they are. The band narrows with every bore; a jump means another insert, tool or material.</translation>
        </message>
        <message>
            <source>Entering a bore</source>
            <translation>Entering a bore</translation>
        </message>
        <message>
            <source>The bore that waits for its diameter. Type the last two figures or the whole diameter and press Enter, press Gauge, or use a hand gauge. What is not plausible is asked about first.</source>
            <translation>The bore that waits for its diameter. Type the last two figures or the whole diameter and press Enter, press Gauge, or use a hand gauge. What is not plausible is asked about first.</translation>
        </message>
        <message>
            <source>Milling</source>
            <translation>Milling</translation>
        </message>
        <message>
            <source>The feed follows the cutting force: where the blank has more stock it slows down, where it has less it hurries. The force stays even, so the wall bends evenly.</source>
            <translation>The feed follows the cutting force: where the blank has more stock it slows down, where it has less it hurries. The force stays even, so the wall bends evenly.</translation>
        </message>
        <message>
            <source>Force and feed</source>
            <translation>Force and feed</translation>
        </message>
        <message>
            <source>The force averaged over a revolution against its reference (dashed) and the overload limit; below, the feed that is really made.</source>
            <translation>The force averaged over a revolution against its reference (dashed) and the overload limit; below, the feed that is really made.</translation>
        </message>
        <message>
            <source>Wall deviation</source>
            <translation>Wall deviation</translation>
        </message>
        <message>
            <source>How far the wall stands from its place along the path, as the force tells it. Waviness is what is left when the mean is taken off.</source>
            <translation>How far the wall stands from its place along the path, as the force tells it. Waviness is what is left when the mean is taken off.</translation>
        </message>
        <message>
            <source>Tool and wear</source>
            <translation>Tool and wear</translation>
        </message>
        <message>
            <source>The cutting stiffness of each part since the tool was new. Wear makes it rise; at the line it is announced.</source>
            <translation>The cutting stiffness of each part since the tool was new. Wear makes it rise; at the line it is announced.</translation>
        </message>
        <message>
            <source>Milling control</source>
            <translation>Milling control</translation>
        </message>
        <message>
            <source>Off, advise or control. Advising, the cut is made at the planned feed and the page says what control would have done, and what it would have saved.</source>
            <translation>Off, advise or control. Advising, the cut is made at the planned feed and the page says what control would have done, and what it would have saved.</translation>
        </message>
        <message>
            <source>Turning</source>
            <translation>Turning</translation>
        </message>
        <message>
            <source>The cutting force shows how deep the tool really is. A fast trim moves the tool against the disturbance, so the face becomes flatter than the machine alone makes it.</source>
            <translation>The cutting force shows how deep the tool really is. A fast trim moves the tool against the disturbance, so the face becomes flatter than the machine alone makes it.</translation>
        </message>
        <message>
            <source>Spectrum</source>
            <translation>Spectrum</translation>
        </message>
        <message>
            <source>What the disturbance consists of. A named line is a frequency that the law has found and cancels, or would cancel.</source>
            <translation>What the disturbance consists of. A named line is a frequency that the law has found and cancels, or would cancel.</translation>
        </message>
        <message>
            <source>Margins</source>
            <translation>Margins</translation>
        </message>
        <message>
            <source>How much the loop may be wrong about the process before it begins to ring: gain, phase, delay. Below the line the law is made milder.</source>
            <translation>How much the loop may be wrong about the process before it begins to ring: gain, phase, delay. Below the line the law is made milder.</translation>
        </message>
        <message>
            <source>Surface</source>
            <translation>Surface</translation>
        </message>
        <message>
            <source>The surface as it is predicted: with the trim, and what it would be without. Root mean square and peak to valley of the last whole revolution.</source>
            <translation>The surface as it is predicted: with the trim, and what it would be without. Root mean square and peak to valley of the last whole revolution.</translation>
        </message>
        <message>
            <source>Thermal</source>
            <translation>Thermal</translation>
        </message>
        <message>
            <source>A warm machine grows, and the work origin moves. From the temperatures the model says how far, and the origin is shifted back.</source>
            <translation>A warm machine grows, and the work origin moves. From the temperatures the model says how far, and the origin is shifted back.</translation>
        </message>
        <message>
            <source>Drift of the origin</source>
            <translation>Drift of the origin</translation>
        </message>
        <message>
            <source>How far the origin has gone in each axis since the temperatures to count from were taken, and the interval in which it is with 95 %. Wider than the part allows: measure.</source>
            <translation>How far the origin has gone in each axis since the temperatures to count from were taken, and the interval in which it is with 95 %. Wider than the part allows: measure.</translation>
        </message>
        <message>
            <source>Thermocouples</source>
            <translation>Thermocouples</translation>
        </message>
        <message>
            <source>Where each one sits and what it reads. One that does not agree with its neighbours is left out and named; the interval becomes wider.</source>
            <translation>Where each one sits and what it reads. One that does not agree with its neighbours is left out and named; the interval becomes wider.</translation>
        </message>
        <message>
            <source>Tapping</source>
            <translation>Tapping</translation>
        </message>
        <message>
            <source>Spindle and Z must keep step, or the thread is cut too wide. Kerf tries gains in the air, proposes better ones, and learns a trim from tap to tap.</source>
            <translation>Spindle and Z must keep step, or the thread is cut too wide. Kerf tries gains in the air, proposes better ones, and learns a trim from tap to tap.</translation>
        </message>
        <message>
            <source>Error along the thread</source>
            <translation>Error along the thread</translation>
        </message>
        <message>
            <source>How far Z is from where the spindle says it should be, over the revolutions in and out, in the band of the thread's class. Now against the first tap.</source>
            <translation>How far Z is from where the spindle says it should be, over the revolutions in and out, in the band of the thread's class. Now against the first tap.</translation>
        </message>
        <message>
            <source>Gains</source>
            <translation>Gains</translation>
        </message>
        <message>
            <source>The drive's gains now, the next that are proposed, and the range that was found safe in the air. Nothing outside of it is ever tried.</source>
            <translation>The drive's gains now, the next that are proposed, and the range that was found safe in the air. Nothing outside of it is ever tried.</translation>
        </message>
        <message>
            <source>What can be done</source>
            <translation>What can be done</translation>
        </message>
        <message>
            <source>An air tap touches nothing. A tuning tries some gains and keeps the best. A tap that stands in the hole is turned out in sync from here, never jogged.</source>
            <translation>An air tap touches nothing. A tuning tries some gains and keeps the best. A tap that stands in the hole is turned out in sync from here, never jogged.</translation>
        </message>
        <message>
            <source>Quality</source>
            <translation>Quality</translation>
        </message>
        <message>
            <source>Whether the process is in control, and what drives it. Signals are about the error against the law's prediction: the raw diameter is moved by the controller itself.</source>
            <translation>Whether the process is in control, and what drives it. Signals are about the error against the law's prediction: the raw diameter is moved by the controller itself.</translation>
        </message>
        <message>
            <source>Indices</source>
            <translation>Indices</translation>
        </message>
        <message>
            <source>How well the lot fits its tolerance. They are shown only where the whole lot is steady: an index of a process that moves says nothing.</source>
            <translation>How well the lot fits its tolerance. They are shown only where the whole lot is steady: an index of a process that moves says nothing.</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Parts</translation>
        </message>
        <message>
            <source>Every part of every process, newest first, with its figures and its verdict. Search by serial number, lot or part type; touch a row for its details, report and corrections.</source>
            <translation>Every part of every process, newest first, with its figures and its verdict. Search by serial number, lot or part type; touch a row for its details, report and corrections.</translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>Shift</translation>
        </message>
        <message>
            <source>What is stored between two handovers: parts with verdicts, pauses longer than three minutes and why, changes with names, alarms and notes. Handing over signs it and begins the next shift.</source>
            <translation>What is stored between two handovers: parts with verdicts, pauses longer than three minutes and why, changes with names, alarms and notes. Handing over signs it and begins the next shift.</translation>
        </message>
        <message>
            <source>What was saved</source>
            <translation>What was saved</translation>
        </message>
        <message>
            <source>Milled parts: the time at the planned feed less the time really cut. Bores: how many are inside their tolerance that would be outside with the recipe's first feed, by the bending found at that time.</source>
            <translation>Milled parts: the time at the planned feed less the time really cut. Bores: how many are inside their tolerance that would be outside with the recipe's first feed, by the bending found at that time.</translation>
        </message>
        <message>
            <source>Sensors</source>
            <translation>Sensors</translation>
        </message>
        <message>
            <source>What is connected, what it reads, how old that is and where it sits. “Which one rises?”: hold a finger on a sensor and see which channel it is.</source>
            <translation>What is connected, what it reads, how old that is and where it sits. “Which one rises?”: hold a finger on a sensor and see which channel it is.</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>Alarms</translation>
        </message>
        <message>
            <source>Each alarm with its cause, what follows from it and what to do. Seen takes it off the bottom line; it stays here until it is gone, then in the history.</source>
            <translation>Each alarm with its cause, what follows from it and what to do. Seen takes it off the bottom line; it stays here until it is gone, then in the history.</translation>
        </message>
        <message>
            <source>Diagnostics</source>
            <translation>Diagnostics</translation>
        </message>
        <message>
            <source>How punctual the engine is, how long a cycle takes, the version, the data file and its backup. For whoever looks after Kerf.</source>
            <translation>How punctual the engine is, how long a cycle takes, the version, the data file and its backup. For whoever looks after Kerf.</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>Off</translation>
        </message>
        <message>
            <source>The loop has no influence: the machine runs as it was programmed. What is measured is still kept.</source>
            <translation>The loop has no influence: the machine runs as it was programmed. What is measured is still kept.</translation>
        </message>
        <message>
            <source>Advise</source>
            <translation>Advise</translation>
        </message>
        <message>
            <source>The loop computes and shows what it would do, and does nothing. The way to get to know it.</source>
            <translation>The loop computes and shows what it would do, and does nothing. The way to get to know it.</translation>
        </message>
        <message>
            <source>Control</source>
            <translation>Control</translation>
        </message>
        <message>
            <source>The loop acts on the machine, within its limits. HOLD ALL takes it off at once.</source>
            <translation>The loop acts on the machine, within its limits. HOLD ALL takes it off at once.</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Start</translation>
        </message>
        <message>
            <source>Starts the program of the next part, where the control allows it. Off, it says what is missing.</source>
            <translation>Starts the program of the next part, where the control allows it. Off, it says what is missing.</translation>
        </message>
        <message>
            <source>Start part</source>
            <translation>Start part</translation>
        </message>
        <message>
            <source>Starts the next part on the simulator, or on a control that allows it. Off, it says why.</source>
            <translation>Starts the next part on the simulator, or on a control that allows it. Off, it says why.</translation>
        </message>
        <message>
            <source>Release hold</source>
            <translation>Release hold</translation>
        </message>
        <message>
            <source>After a look at the machine: the loops go on in the mode they had, without a jump. A stop stays until it is released by its own button.</source>
            <translation>After a look at the machine: the loops go on in the mode they had, without a jump. A stop stays until it is released by its own button.</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Feed</translation>
        </message>
        <message>
            <source>How fast the axis moves now, as the control reports it. Grey: not fresh.</source>
            <translation>How fast the axis moves now, as the control reports it. Grey: not fresh.</translation>
        </message>
        <message>
            <source>Parts since start</source>
            <translation>Parts since start</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Accept</translation>
        </message>
        <message>
            <source>In advise mode: the schedule shown is what the next part shall be cut with. It is written down with the name. In control every schedule is used by itself. Its bores are expected within the 95 % interval shown.</source>
            <translation>In advise mode: the schedule shown is what the next part shall be cut with. It is written down with the name. In control every schedule is used by itself. Its bores are expected within the 95 % interval shown.</translation>
        </message>
        <message>
            <source>Tool or material changed</source>
            <translation>Tool or material changed</translation>
        </message>
        <message>
            <source>Two touches after a new insert, a reground tool or another batch of material: the next bore is expected from what such changes have brought before, with a wider interval.</source>
            <translation>Two touches after a new insert, a reground tool or another batch of material: the next bore is expected from what such changes have brought before, with a wider interval.</translation>
        </message>
        <message>
            <source>Next lot</source>
            <translation>Next lot</translation>
        </message>
        <message>
            <source>This lot is complete or closed: here the next one is opened.</source>
            <translation>This lot is complete or closed: here the next one is opened.</translation>
        </message>
        <message>
            <source>Undo last</source>
            <translation>Undo last</translation>
        </message>
        <message>
            <source>Takes the newest diameter back. It stays in the records, with who undid it.</source>
            <translation>Takes the newest diameter back. It stays in the records, with who undid it.</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>Correct</translation>
        </message>
        <message>
            <source>All diameters of the lot: touch one to correct it or take it out, with a reason. Everything after it is computed again.</source>
            <translation>All diameters of the lot: touch one to correct it or take it out, with a reason. Everything after it is computed again.</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>Gauge</translation>
        </message>
        <message>
            <source>On the simulator: measures the bore that waits. On a machine the gauge sends by its own key.</source>
            <translation>On the simulator: measures the bore that waits. On a machine the gauge sends by its own key.</translation>
        </message>
        <message>
            <source>Measure again</source>
            <translation>Measure again</translation>
        </message>
        <message>
            <source>Leaves the value that was asked about and waits for another one. Nothing was stored.</source>
            <translation>Leaves the value that was asked about and waits for another one. Nothing was stored.</translation>
        </message>
        <message>
            <source>Confirm</source>
            <translation>Confirm</translation>
        </message>
        <message>
            <source>The value is far from what was expected, and it is right: it is stored as confirmed.</source>
            <translation>The value is far from what was expected, and it is right: it is stored as confirmed.</translation>
        </message>
        <message>
            <source>Channels</source>
            <translation>Channels</translation>
        </message>
        <message>
            <source>Which channel of the gauge box stands for which depth. Learnt once, changed here.</source>
            <translation>Which channel of the gauge box stands for which depth. Learnt once, changed here.</translation>
        </message>
        <message>
            <source>Expected diameter</source>
            <translation>Expected diameter</translation>
        </message>
        <message>
            <source>What the next part is expected to measure at this depth. 19 of 20 bores fall into the interval beside it.</source>
            <translation>What the next part is expected to measure at this depth. 19 of 20 bores fall into the interval beside it.</translation>
        </message>
        <message>
            <source>Force</source>
            <translation>Force</translation>
        </message>
        <message>
            <source>Mean force of the last revolution; this is what is held.</source>
            <translation>Mean force of the last revolution; this is what is held.</translation>
        </message>
        <message>
            <source>Force of single teeth</source>
            <translation>Force of single teeth</translation>
        </message>
        <message>
            <source>Lowest and highest force since the last picture: what the tool really feels.</source>
            <translation>Lowest and highest force since the last picture: what the tool really feels.</translation>
        </message>
        <message>
            <source>Feed now; under control it goes where the force wants it.</source>
            <translation>Feed now; under control it goes where the force wants it.</translation>
        </message>
        <message>
            <source>How the tool cuts</source>
            <translation>How the tool cuts</translation>
        </message>
        <message>
            <source>How hard this tool works for its feed, as learnt from its cuts. It grows as the tool wears.</source>
            <translation>How hard this tool works for its feed, as learnt from its cuts. It grows as the tool wears.</translation>
        </message>
        <message>
            <source>New tool</source>
            <translation>New tool</translation>
        </message>
        <message>
            <source>Another tool is in: wear is counted anew, and what tools of its kind have taught is used.</source>
            <translation>Another tool is in: wear is counted anew, and what tools of its kind have taught is used.</translation>
        </message>
        <message>
            <source>Teach</source>
            <translation>Teach</translation>
        </message>
        <message>
            <source>Takes the mean force of the last good cut as the reference that the feed shall hold.</source>
            <translation>Takes the mean force of the last good cut as the reference that the feed shall hold.</translation>
        </message>
        <message>
            <source>Release the stop</source>
            <translation>Release the stop</translation>
        </message>
        <message>
            <source>The feed was stopped by an overload or a broken tool. After a look at tool and work, this lets the next cut begin; it needs a name.</source>
            <translation>The feed was stopped by an overload or a broken tool. After a look at tool and work, this lets the next cut begin; it needs a name.</translation>
        </message>
        <message>
            <source>Reference force</source>
            <translation>Reference force</translation>
        </message>
        <message>
            <source>The force that the feed holds: higher is faster, and bends the tool more.</source>
            <translation>The force that the feed holds: higher is faster, and bends the tool more.</translation>
        </message>
        <message>
            <source>Peak force</source>
            <translation>Peak force</translation>
        </message>
        <message>
            <source>Highest force of this cut, of single teeth.</source>
            <translation>Highest force of this cut, of single teeth.</translation>
        </message>
        <message>
            <source>Saved</source>
            <translation>Saved</translation>
        </message>
        <message>
            <source>Time against the planned feed on the same path; in advise mode, what control would save.</source>
            <translation>Time against the planned feed on the same path; in advise mode, what control would save.</translation>
        </message>
        <message>
            <source>Law</source>
            <translation>Law</translation>
        </message>
        <message>
            <source>How the feed is found from the force. Model is the default; the others are there to compare.</source>
            <translation>How the feed is found from the force. Model is the default; the others are there to compare.</translation>
        </message>
        <message>
            <source>Setup</source>
            <translation>Setup</translation>
        </message>
        <message>
            <source>Tool, path, planned feed, reference and limits of the next cuts.</source>
            <translation>Tool, path, planned feed, reference and limits of the next cuts.</translation>
        </message>
        <message>
            <source>Blank</source>
            <translation>Blank</translation>
        </message>
        <message>
            <source>How much stands on the blank along the path, so that the feed is ready before a step comes.</source>
            <translation>How much stands on the blank along the path, so that the feed is ready before a step comes.</translation>
        </message>
        <message>
            <source>Log</source>
            <translation>Log</translation>
        </message>
        <message>
            <source>The last cuts with force, waviness and time.</source>
            <translation>The last cuts with force, waviness and time.</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Tools</translation>
        </message>
        <message>
            <source>What was learnt of tools of this kind; one can be left out, with a reason.</source>
            <translation>What was learnt of tools of this kind; one can be left out, with a reason.</translation>
        </message>
        <message>
            <source>Depth, speed and path of the next cut, and how far the trim may go.</source>
            <translation>Depth, speed and path of the next cut, and how far the trim may go.</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Open</translation>
        </message>
        <message>
            <source>No trim: what the lathe does by itself.</source>
            <translation>No trim: what the lathe does by itself.</translation>
        </message>
        <message>
            <source>Paper</source>
            <translation>Paper</translation>
        </message>
        <message>
            <source>The controller of the published work, for comparison.</source>
            <translation>The controller of the published work, for comparison.</translation>
        </message>
        <message>
            <source>PI</source>
            <translation>PI</translation>
        </message>
        <message>
            <source>A tuned PI controller, for comparison.</source>
            <translation>A tuned PI controller, for comparison.</translation>
        </message>
        <message>
            <source>Tones</source>
            <translation>Tones</translation>
        </message>
        <message>
            <source>The default: a broadband law, and one for each vibration it finds; none has to be named.</source>
            <translation>The default: a broadband law, and one for each vibration it finds; none has to be named.</translation>
        </message>
        <message>
            <source>Tune</source>
            <translation>Tune</translation>
        </message>
        <message>
            <source>Taps in the air, then proposes gains that match spindle and Z, and says what limits them.</source>
            <translation>Taps in the air, then proposes gains that match spindle and Z, and says what limits them.</translation>
        </message>
        <message>
            <source>Turn out</source>
            <translation>Turn out</translation>
        </message>
        <message>
            <source>A tap stands in the hole: spindle and Z turn it out together.</source>
            <translation>A tap stands in the hole: spindle and Z turn it out together.</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>Job</translation>
        </message>
        <message>
            <source>Thread, depth, speed and class of what is tapped.</source>
            <translation>Thread, depth, speed and class of what is tapped.</translation>
        </message>
        <message>
            <source>Tap</source>
            <translation>Tap</translation>
        </message>
        <message>
            <source>One tap with the gains in force, in the work or in the air.</source>
            <translation>One tap with the gains in force, in the work or in the air.</translation>
        </message>
        <message>
            <source>One more</source>
            <translation>One more</translation>
        </message>
        <message>
            <source>One more trial before the proposal is made.</source>
            <translation>One more trial before the proposal is made.</translation>
        </message>
        <message>
            <source>The gains proposed are used from now on, and kept with your name.</source>
            <translation>The gains proposed are used from now on, and kept with your name.</translation>
        </message>
        <message>
            <source>Roll back</source>
            <translation>Roll back</translation>
        </message>
        <message>
            <source>Back to the gains that were in force before.</source>
            <translation>Back to the gains that were in force before.</translation>
        </message>
        <message>
            <source>Abort</source>
            <translation>Abort</translation>
        </message>
        <message>
            <source>Turns the tap out in step with Z and goes back to the gains accepted last.</source>
            <translation>Turns the tap out in step with Z and goes back to the gains accepted last.</translation>
        </message>
        <message>
            <source>Trials follow each other without a touch, until a proposal is there.</source>
            <translation>Trials follow each other without a touch, until a proposal is there.</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>Drift</translation>
        </message>
        <message>
            <source>How far the origin is thought to have moved since the reference, with the interval in which it lies on 19 of 20 minutes. Measuring makes it narrow.</source>
            <translation>How far the origin is thought to have moved since the reference, with the interval in which it lies on 19 of 20 minutes. Measuring makes it narrow.</translation>
        </message>
        <message>
            <source>Warm up</source>
            <translation>Warm up</translation>
        </message>
        <message>
            <source>Runs the warm-up program until the drift is small enough to cut.</source>
            <translation>Runs the warm-up program until the drift is small enough to cut.</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>Measure</translation>
        </message>
        <message>
            <source>Measures the origin: the prediction counts on from what was measured, at once.</source>
            <translation>Measures the origin: the prediction counts on from what was measured, at once.</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>Model</translation>
        </message>
        <message>
            <source>Which days the model has learnt from, how well it told days it had not seen, train, go back.</source>
            <translation>Which days the model has learnt from, how well it told days it had not seen, train, go back.</translation>
        </message>
        <message>
            <source>History</source>
            <translation>History</translation>
        </message>
        <message>
            <source>Every shift of the origin, with when and why.</source>
            <translation>Every shift of the origin, with when and why.</translation>
        </message>
        <message>
            <source>Thermocouples: where each sits, and its health.</source>
            <translation>Thermocouples: where each sits, and its health.</translation>
        </message>
        <message>
            <source>Map</source>
            <translation>Map</translation>
        </message>
        <message>
            <source>How the error of the axes differs over the table.</source>
            <translation>How the error of the axes differs over the table.</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>Limits</translation>
        </message>
        <message>
            <source>How far and how often the origin may be shifted.</source>
            <translation>How far and how often the origin may be shifted.</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>Place</translation>
        </message>
        <message>
            <source>Touch the picture where this sensor sits.</source>
            <translation>Touch the picture where this sensor sits.</translation>
        </message>
        <message>
            <source>Acknowledge</source>
            <translation>Acknowledge</translation>
        </message>
        <message>
            <source>Somebody has seen this alarm; the name goes into the history. It stays until its cause is gone.</source>
            <translation>Somebody has seen this alarm; the name goes into the history. It stays until its cause is gone.</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>Now</translation>
        </message>
        <message>
            <source>Alarms that stand now, the most urgent first.</source>
            <translation>Alarms that stand now, the most urgent first.</translation>
        </message>
        <message>
            <source>All alarms, with when they came and went, and who has seen them.</source>
            <translation>All alarms, with when they came and went, and who has seen them.</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Export</translation>
        </message>
        <message>
            <source>The history as shown, as a table into a folder of your choice. No file is written over.</source>
            <translation>The history as shown, as a table into a folder of your choice. No file is written over.</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>Search</translation>
        </message>
        <message>
            <source>Part number, serial number, lot or part type; what is typed is looked for as it is typed.</source>
            <translation>Part number, serial number, lot or part type; what is typed is looked for as it is typed.</translation>
        </message>
        <message>
            <source>Out of tolerance</source>
            <translation>Out of tolerance</translation>
        </message>
        <message>
            <source>Only parts with rework or scrap.</source>
            <translation>Only parts with rework or scrap.</translation>
        </message>
        <message>
            <source>This lot</source>
            <translation>This lot</translation>
        </message>
        <message>
            <source>Only parts of the lot that is open.</source>
            <translation>Only parts of the lot that is open.</translation>
        </message>
        <message>
            <source>The parts shown, as a table for Excel or programs, into a folder of your choice.</source>
            <translation>The parts shown, as a table for Excel or programs, into a folder of your choice.</translation>
        </message>
        <message>
            <source>Another value for the diameter chosen, with a reason. The old one stays in the records.</source>
            <translation>Another value for the diameter chosen, with a reason. The old one stays in the records.</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>Take out</translation>
        </message>
        <message>
            <source>The diameter chosen no longer counts, with a reason. It stays in the records.</source>
            <translation>The diameter chosen no longer counts, with a reason. It stays in the records.</translation>
        </message>
        <message>
            <source>Serial</source>
            <translation>Serial</translation>
        </message>
        <message>
            <source>Gives the part its serial number, or another one.</source>
            <translation>Gives the part its serial number, or another one.</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>Report</translation>
        </message>
        <message>
            <source>One page about this part as PDF: diameters, tolerance, verdict, feed.</source>
            <translation>One page about this part as PDF: diameters, tolerance, verdict, feed.</translation>
        </message>
        <message>
            <source>What was done with parts outside their limits: reworked, scrapped, released by whom.</source>
            <translation>What was done with parts outside their limits: reworked, scrapped, released by whom.</translation>
        </message>
        <message>
            <source>Files</source>
            <translation>Files</translation>
        </message>
        <message>
            <source>Reports of the lot, and Q-DAS files by hand or by themselves into a folder.</source>
            <translation>Reports of the lot, and Q-DAS files by hand or by themselves into a folder.</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>Gauges</translation>
        </message>
        <message>
            <source>The register of gauges: range, due date, studies of a ring and of several people.</source>
            <translation>The register of gauges: range, due date, studies of a ring and of several people.</translation>
        </message>
        <message>
            <source>Limits of the figures of milled, turned and tapped parts, by which they are judged.</source>
            <translation>Limits of the figures of milled, turned and tapped parts, by which they are judged.</translation>
        </message>
        <message>
            <source>Older</source>
            <translation>Older</translation>
        </message>
        <message>
            <source>The parts before those shown.</source>
            <translation>The parts before those shown.</translation>
        </message>
        <message>
            <source>Newer</source>
            <translation>Newer</translation>
        </message>
        <message>
            <source>The parts after those shown.</source>
            <translation>The parts after those shown.</translation>
        </message>
        <message>
            <source>Leave a note</source>
            <translation>Leave a note</translation>
        </message>
        <message>
            <source>A sentence for the next shift, signed with your name.</source>
            <translation>A sentence for the next shift, signed with your name.</translation>
        </message>
        <message>
            <source>Hand over</source>
            <translation>Hand over</translation>
        </message>
        <message>
            <source>Signs this shift; the next one begins now and reads your words first.</source>
            <translation>Signs this shift; the next one begins now and reads your words first.</translation>
        </message>
        <message>
            <source>One page (PDF)</source>
            <translation>One page (PDF)</translation>
        </message>
        <message>
            <source>The shift as it stands here, on one page.</source>
            <translation>The shift as it stands here, on one page.</translation>
        </message>
        <message>
            <source>Shift before</source>
            <translation>Shift before</translation>
        </message>
        <message>
            <source>The shift that was handed over before the one shown.</source>
            <translation>The shift that was handed over before the one shown.</translation>
        </message>
        <message>
            <source>This shift</source>
            <translation>This shift</translation>
        </message>
        <message>
            <source>Back to the shift that goes on.</source>
            <translation>Back to the shift that goes on.</translation>
        </message>
        <message>
            <source>Stops</source>
            <translation>Stops</translation>
        </message>
        <message>
            <source>Pauses of more than three minutes. Touch one and say why; two touches.</source>
            <translation>Pauses of more than three minutes. Touch one and say why; two touches.</translation>
        </message>
        <message>
            <source>Which one rises?</source>
            <translation>Which one rises?</translation>
        </message>
        <message>
            <source>Warm a thermocouple with a finger: the one that rises first is named, so that its place on the picture can be set.</source>
            <translation>Warm a thermocouple with a finger: the one that rises first is named, so that its place on the picture can be set.</translation>
        </message>
        <message>
            <source>Ask the gauge</source>
            <translation>Ask the gauge</translation>
        </message>
        <message>
            <source>Asks a gauge for a reading, to see that it answers.</source>
            <translation>Asks a gauge for a reading, to see that it answers.</translation>
        </message>
        <message>
            <source>Back up all data</source>
            <translation>Back up all data</translation>
        </message>
        <message>
            <source>A checked copy of everything in one file, made while everything goes on.</source>
            <translation>A checked copy of everything in one file, made while everything goes on.</translation>
        </message>
        <message>
            <source>Restore a backup</source>
            <translation>Restore a backup</translation>
        </message>
        <message>
            <source>Puts a backup in the place of the data at the next start. What is there now is set aside. For process engineers, with a reason.</source>
            <translation>Puts a backup in the place of the data at the next start. What is there now is set aside. For process engineers, with a reason.</translation>
        </message>
        <message>
            <source>Lots</source>
            <translation>Lots</translation>
        </message>
        <message>
            <source>Open, choose or close a lot; recipes of the part types.</source>
            <translation>Open, choose or close a lot; recipes of the part types.</translation>
        </message>
        <message>
            <source>Who is there</source>
            <translation>Who is there</translation>
        </message>
        <message>
            <source>Sign on, sign off, people and their roles; a second person for limits.</source>
            <translation>Sign on, sign off, people and their roles; a second person for limits.</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>Settings</translation>
        </message>
        <message>
            <source>Language, units, light or dark, size of the text.</source>
            <translation>Language, units, light or dark, size of the text.</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>Language</translation>
        </message>
        <message>
            <source>Korean or English, at once, on all pages.</source>
            <translation>Korean or English, at once, on all pages.</translation>
        </message>
        <message>
            <source>Simulator</source>
            <translation>Simulator</translation>
        </message>
        <message>
            <source>How much faster than time the simulated machine runs. A real machine has no such button.</source>
            <translation>How much faster than time the simulated machine runs. A real machine has no such button.</translation>
        </message>
        <message>
            <source>Archive of parts</source>
            <translation>Archive of parts</translation>
        </message>
        <message>
            <source>The parts turned so far, with surface, force and trim of each.</source>
            <translation>The parts turned so far, with surface, force and trim of each.</translation>
        </message>
        <message>
            <source>Automatic</source>
            <translation>Automatic</translation>
        </message>
        <message>
            <source>Gain margin</source>
            <translation>Gain margin</translation>
        </message>
        <message>
            <source>How many times stronger the law could act before the force begins to swing; below two it is close.</source>
            <translation>How many times stronger the law could act before the force begins to swing; below two it is close.</translation>
        </message>
        <message>
            <source>Unevenness</source>
            <translation>Unevenness</translation>
        </message>
        <message>
            <source>How far the face is from flat on average (root mean square), as predicted from the force.</source>
            <translation>How far the face is from flat on average (root mean square), as predicted from the force.</translation>
        </message>
        <message>
            <source>Highest to lowest point</source>
            <translation>Highest to lowest point</translation>
        </message>
        <message>
            <source>Peak to valley of the last whole revolution, as predicted from the force.</source>
            <translation>Peak to valley of the last whole revolution, as predicted from the force.</translation>
        </message>
        <message>
            <source>Without the trim</source>
            <translation>Without the trim</translation>
        </message>
        <message>
            <source>What the unevenness would be if the trim stood still: the difference is the loop's work.</source>
            <translation>What the unevenness would be if the trim stood still: the difference is the loop's work.</translation>
        </message>
        <message>
            <source>By how much stronger the cut may answer than it was identified before the loop rings.</source>
            <translation>By how much stronger the cut may answer than it was identified before the loop rings.</translation>
        </message>
        <message>
            <source>Phase margin</source>
            <translation>Phase margin</translation>
        </message>
        <message>
            <source>By which angle the answer may come later before the loop rings.</source>
            <translation>By which angle the answer may come later before the loop rings.</translation>
        </message>
        <message>
            <source>Delay margin</source>
            <translation>Delay margin</translation>
        </message>
        <message>
            <source>By how much time the answer may come later before the loop rings.</source>
            <translation>By how much time the answer may come later before the loop rings.</translation>
        </message>
        <message>
            <source>Modulus margin</source>
            <translation>Modulus margin</translation>
        </message>
        <message>
            <source>Smallest distance of the open loop from the point where it rings: 1 is calm, 0 rings.</source>
            <translation>Smallest distance of the open loop from the point where it rings: 1 is calm, 0 rings.</translation>
        </message>
        <message>
            <source>Rules</source>
            <translation>Rules</translation>
        </message>
        <message>
            <source>Which rules of the charts are on, for page, report and alarm. Few at once: each alarms wrongly now and then.</source>
            <translation>Which rules of the charts are on, for page, report and alarm. Few at once: each alarms wrongly now and then.</translation>
        </message>
        <message>
            <source>Parts finished since this console was started, whatever process made them; an air tap makes none.</source>
            <translation>Parts finished since this console was started, whatever process made them; an air tap makes none.</translation>
        </message>
        <message>
            <source>Parts begun since this console was started, whatever process made them.</source>
            <translation>Parts begun since this console was started, whatever process made them.</translation>
        </message>
        <message>
            <source>The parts turned so far, with surface, force and trim of each; one can be left out of what the next begin from, with a reason.</source>
            <translation>The parts turned so far, with surface, force and trim of each; one can be left out of what the next begin from, with a reason.</translation>
        </message>
        <message>
            <source>Place on the picture</source>
            <translation>Place on the picture</translation>
        </message>
        <message>
            <source>The channel that was touched gets its point on the picture of the machine: touch where it sits.</source>
            <translation>The channel that was touched gets its point on the picture of the machine: touch where it sits.</translation>
        </message>
        <message>
            <source>Sensor file and modules</source>
            <translation>Sensor file and modules</translation>
        </message>
        <message>
            <source>Which sensor file the next start reads, and what answers at an address of the network.</source>
            <translation>Which sensor file the next start reads, and what answers at an address of the network.</translation>
        </message>
        <message>
            <source>Use this file</source>
            <translation>Use this file</translation>
        </message>
        <message>
            <source>The sensor file that was touched is read from the next start of the console on. For process engineers.</source>
            <translation>The sensor file that was touched is read from the next start of the console on. For process engineers.</translation>
        </message>
        <message>
            <source>Use none</source>
            <translation>Use none</translation>
        </message>
        <message>
            <source>From the next start on only what the machine itself brings is read.</source>
            <translation>From the next start on only what the machine itself brings is read.</translation>
        </message>
        <message>
            <source>Look again</source>
            <translation>Look again</translation>
        </message>
        <message>
            <source>Looks through the folder for sensor files again.</source>
            <translation>Looks through the folder for sensor files again.</translation>
        </message>
        <message>
            <source>Ask what is there</source>
            <translation>Ask what is there</translation>
        </message>
        <message>
            <source>Asks units 1 to 32 at the address for their first registers. Nothing is written.</source>
            <translation>Asks units 1 to 32 at the address for their first registers. Nothing is written.</translation>
        </message>
    </context>
    <context>
    <name>LotReport</name>
        <message>
            <source>Nothing to show yet.</source>
            <translation>Nothing to show yet.</translation>
        </message>
        <message>
            <source>part %1</source>
            <translation>part %1</translation>
        </message>
        <message>
            <source>%1: newest parts</source>
            <translation>%1: newest parts</translation>
        </message>
        <message>
            <source>First article of %2, lot %1</source>
            <translation>First article of %2, lot %1</translation>
        </message>
        <message>
            <source>Lot %1 of %2</source>
            <translation>Lot %1 of %2</translation>
        </message>
        <message>
            <source>%1 on %2, recipe revision %3, opened %4</source>
            <translation>%1 on %2, recipe revision %3, opened %4</translation>
        </message>
        <message>
            <source>Drawing, order: ____________________</source>
            <translation>Drawing, order: ____________________</translation>
        </message>
        <message>
            <source>Parts %1 to %2, %3 to %4</source>
            <translation>Parts %1 to %2, %3 to %4</translation>
        </message>
        <message>
            <source>%1 parts: %2 good, %3 rework possible, %4 scrap, %5 not judged</source>
            <translation>%1 parts: %2 good, %3 rework possible, %4 scrap, %5 not judged</translation>
        </message>
        <message>
            <source>Characteristic</source>
            <translation>Characteristic</translation>
        </message>
        <message>
            <source>Found</source>
            <translation>Found</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>Tolerance</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Verdict</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1 to %2</translation>
        </message>
        <message>
            <source>Tolerance %1 to %2, mean %3, s %4</source>
            <translation>Tolerance %1 to %2, mean %3, s %4</translation>
        </message>
        <message>
            <source>Measured, with tolerance</source>
            <translation>Measured, with tolerance</translation>
        </message>
        <message>
            <source>Error against the law, σ</source>
            <translation>Error against the law, σ</translation>
        </message>
        <message>
            <source>Parts out of tolerance</source>
            <translation>Parts out of tolerance</translation>
        </message>
        <message>
            <source>no decision yet</source>
            <translation>no decision yet</translation>
        </message>
        <message>
            <source>None.</source>
            <translation>None.</translation>
        </message>
        <message>
            <source>Corrections</source>
            <translation>Corrections</translation>
        </message>
        <message>
            <source>taken out</source>
            <translation>taken out</translation>
        </message>
        <message>
            <source>Part %1: %2 → %3, %4, %5: %6</source>
            <translation>Part %1: %2 → %3, %4, %5: %6</translation>
        </message>
        <message>
            <source>tool reground</source>
            <translation>tool reground</translation>
        </message>
        <message>
            <source>other material</source>
            <translation>other material</translation>
        </message>
        <message>
            <source>new insert</source>
            <translation>new insert</translation>
        </message>
        <message>
            <source>no change after all</source>
            <translation>no change after all</translation>
        </message>
        <message>
            <source>Signals and changes of the process</source>
            <translation>Signals and changes of the process</translation>
        </message>
        <message>
            <source>From part %1 on: %2</source>
            <translation>From part %1 on: %2</translation>
        </message>
        <message>
            <source>Part %1: %2</source>
            <translation>Part %1: %2</translation>
        </message>
        <message>
            <source>Part %1: the estimator noticed a process change.</source>
            <translation>Part %1: the estimator noticed a process change.</translation>
        </message>
        <message>
            <source>Alarms during the lot</source>
            <translation>Alarms during the lot</translation>
        </message>
        <message>
            <source>acknowledged by %1</source>
            <translation>acknowledged by %1</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>Gauges</translation>
        </message>
        <message>
            <source>σ of the estimator: %1</source>
            <translation>σ of the estimator: %1</translation>
        </message>
        <message>
            <source>Head of the audit chain: entry %1, %2</source>
            <translation>Head of the audit chain: entry %1, %2</translation>
        </message>
        <message>
            <source>Date, name, signature</source>
            <translation>Date, name, signature</translation>
        </message>
        <message>
            <source>Kerf %1, written %2. The data is attached as DFQ and CSV.</source>
            <translation>Kerf %1, written %2. The data is attached as DFQ and CSV.</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>where from, how many</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Values: %1</source>
            <translation>Values: %1</translation>
        </message>
        <message>
            <source>Part %1</source>
            <translation>Part %1</translation>
        </message>
        <message>
            <source>Verdict: %1</source>
            <translation>Verdict: %1</translation>
        </message>
        <message>
            <source>Verdicts: %1 good, %2 rework possible, %3 scrap, %4 not judged</source>
            <translation>Verdicts: %1 good, %2 rework possible, %3 scrap, %4 not judged</translation>
        </message>
        <message>
            <source>good enough</source>
            <translation>good enough</translation>
        </message>
        <message>
            <source>not good enough</source>
            <translation>not good enough</translation>
        </message>
    </context>
    <context>
    <name>Lots</name>
        <message>
            <source>The next parts are of lot %1 of %2.</source>
            <translation>The next parts are of lot %1 of %2.</translation>
        </message>
        <message>
            <source>The next parts of %1 are of no lot.</source>
            <translation>The next parts of %1 are of no lot.</translation>
        </message>
        <message>
            <source>Lot</source>
            <translation>Lot</translation>
        </message>
        <message>
            <source>Part type</source>
            <translation>Part type</translation>
        </message>
        <message>
            <source>Rev.</source>
            <translation>Rev.</translation>
        </message>
        <message>
            <source>When, by</source>
            <translation>When, by</translation>
        </message>
        <message>
            <source>lot %1</source>
            <translation>lot %1</translation>
        </message>
        <message>
            <source>Lots of %1</source>
            <translation>Lots of %1</translation>
        </message>
        <message>
            <source>Name of a new lot</source>
            <translation>Name of a new lot</translation>
        </message>
        <message>
            <source>Parts, if known</source>
            <translation>Parts, if known</translation>
        </message>
        <message>
            <source>Tool or insert</source>
            <translation>Tool or insert</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>Gauge</translation>
        </message>
        <message>
            <source>Reason to close the lot</source>
            <translation>Reason to close the lot</translation>
        </message>
        <message>
            <source>Close the sheet</source>
            <translation>Close the sheet</translation>
        </message>
        <message>
            <source>no lot is open</source>
            <translation>no lot is open</translation>
        </message>
        <message>
            <source>Close the lot</source>
            <translation>Close the lot</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>give a reason</translation>
        </message>
        <message>
            <source>Parts of no lot</source>
            <translation>Parts of no lot</translation>
        </message>
        <message>
            <source>Go on with it</source>
            <translation>Go on with it</translation>
        </message>
        <message>
            <source>touch a lot</source>
            <translation>touch a lot</translation>
        </message>
        <message>
            <source>it is closed</source>
            <translation>it is closed</translation>
        </message>
        <message>
            <source>Open the lot</source>
            <translation>Open the lot</translation>
        </message>
        <message>
            <source>type a name</source>
            <translation>type a name</translation>
        </message>
        <message>
            <source>0 to 100000 parts</source>
            <translation>0 to 100000 parts</translation>
        </message>
        <message>
            <source>Lots</source>
            <translation>Lots</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Parts</translation>
        </message>
        <message>
            <source>Tool, gauge</source>
            <translation>Tool, gauge</translation>
        </message>
    </context>
    <context>
    <name>Milling</name>
        <message>
            <source>Constant feed</source>
            <translation>Constant feed</translation>
        </message>
        <message>
            <source>PI</source>
            <translation>PI</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>Model</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>Preview</translation>
        </message>
        <message>
            <source>as long as planned</source>
            <translation>as long as planned</translation>
        </message>
        <message>
            <source>%1 s faster than planned</source>
            <translation>%1 s faster than planned</translation>
        </message>
        <message>
            <source>%1 s slower than planned</source>
            <translation>%1 s slower than planned</translation>
        </message>
        <message>
            <source>control would be %1</source>
            <translation>control would be %1</translation>
        </message>
        <message>
            <source>peak %1 at %2</source>
            <translation>peak %1 at %2</translation>
        </message>
        <message>
            <source>waviness %1</source>
            <translation>waviness %1</translation>
        </message>
        <message>
            <source>would have been stopped</source>
            <translation>would have been stopped</translation>
        </message>
        <message>
            <source>was stopped</source>
            <translation>was stopped</translation>
        </message>
        <message>
            <source>Cut %1: %2.</source>
            <translation>Cut %1: %2.</translation>
        </message>
        <message>
            <source>Cut %1, aborted: %2.</source>
            <translation>Cut %1, aborted: %2.</translation>
        </message>
        <message>
            <source>typed</source>
            <comment>blank profile</comment>
            <translation>typed</translation>
        </message>
    </context>
    <context>
    <name>MillingCutLog</name>
        <message>
            <source>%1, aborted</source>
            <translation>%1, aborted</translation>
        </message>
        <message>
            <source>Last cuts</source>
            <translation>Last cuts</translation>
        </message>
        <message>
            <source>An advised cut was made at the planned feed; its controlled time is what control would have taken.</source>
            <translation>An advised cut was made at the planned feed; its controlled time is what control would have taken.</translation>
        </message>
        <message>
            <source>cut</source>
            <translation>cut</translation>
        </message>
        <message>
            <source>law</source>
            <translation>law</translation>
        </message>
        <message>
            <source>mode</source>
            <translation>mode</translation>
        </message>
        <message>
            <source>planned
%1</source>
            <translation>planned
%1</translation>
        </message>
        <message>
            <source>controlled
%1</source>
            <translation>controlled
%1</translation>
        </message>
        <message>
            <source>peak
%1</source>
            <translation>peak
%1</translation>
        </message>
        <message>
            <source>at
%1</source>
            <translation>at
%1</translation>
        </message>
        <message>
            <source>waviness
%1</source>
            <translation>waviness
%1</translation>
        </message>
        <message>
            <source>stops</source>
            <translation>stops</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
    </context>
    <context>
    <name>OperatorChooser</name>
        <message>
            <source>Who is at the machine?</source>
            <translation>Who is at the machine?</translation>
        </message>
        <message>
            <source>The name goes with every entry and correction.</source>
            <translation>The name goes with every entry and correction.</translation>
        </message>
        <message>
            <source>New name</source>
            <translation>New name</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Sign off</source>
            <translation>Sign off</translation>
        </message>
        <message>
            <source>Sign on</source>
            <translation>Sign on</translation>
        </message>
        <message>
            <source>Type your PIN.</source>
            <translation>Type your PIN.</translation>
        </message>
        <message>
            <source>This PIN does not fit.</source>
            <translation>This PIN does not fit.</translation>
        </message>
        <message>
            <source>People</source>
            <translation>People</translation>
        </message>
        <message>
            <source>nobody is known yet</source>
            <translation>nobody is known yet</translation>
        </message>
        <message>
            <source>Demonstration on a simulated machine: a new name may take any role until there is a process engineer.</source>
            <translation>Demonstration on a simulated machine: a new name may take any role until there is a process engineer.</translation>
        </message>
        <message>
            <source>Who says yes as well?</source>
            <translation>Who says yes as well?</translation>
        </message>
        <message>
            <source>For two minutes %1 may raise a limit by more than half.</source>
            <translation>For two minutes %1 may raise a limit by more than half.</translation>
        </message>
        <message>
            <source>Second person</source>
            <translation>Second person</translation>
        </message>
        <message>
            <source>no other setter or engineer has a PIN</source>
            <translation>no other setter or engineer has a PIN</translation>
        </message>
        <message>
            <source>%1 has said yes</source>
            <translation>%1 has said yes</translation>
        </message>
    </context>
    <context>
    <name>Pages</name>
        <message>
            <source>Feed</source>
            <translation>Feed</translation>
        </message>
        <message>
            <source>Next bore</source>
            <translation>Next bore</translation>
        </message>
        <message>
            <source>Next bore, %1</source>
            <translation>Next bore, %1</translation>
        </message>
        <message>
            <source>Overview</source>
            <translation>Overview</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>Alarms</translation>
        </message>
        <message>
            <source>Diagnostics</source>
            <translation>Diagnostics</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Parts</translation>
        </message>
        <message>
            <source>Waviness of the cut</source>
            <translation>Waviness of the cut</translation>
        </message>
        <message>
            <source>Last tap, p-p in the work</source>
            <translation>Last tap, p-p in the work</translation>
        </message>
        <message>
            <source>Sensors</source>
            <translation>Sensors</translation>
        </message>
        <message>
            <source>Quality</source>
            <translation>Quality</translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>Shift</translation>
        </message>
        <message>
            <source>Tuned tap, p-p in the work</source>
            <translation>Tuned tap, p-p in the work</translation>
        </message>
    </context>
    <context>
    <name>PartReport</name>
        <message>
            <source>Feed over overhang, %1 over %2: dashed the schedule, solid as cut.</source>
            <comment>units</comment>
            <translation>Feed over overhang, %1 over %2: dashed the schedule, solid as cut.</translation>
        </message>
        <message>
            <source>correction</source>
            <translation>correction</translation>
        </message>
        <message>
            <source>taken out</source>
            <translation>taken out</translation>
        </message>
        <message>
            <source>confirmed</source>
            <translation>confirmed</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Depth</translation>
        </message>
        <message>
            <source>⌀, %1</source>
            <translation>⌀, %1</translation>
        </message>
        <message>
            <source>By, when</source>
            <translation>By, when</translation>
        </message>
        <message>
            <source>What, why</source>
            <translation>What, why</translation>
        </message>
        <message>
            <source>no longer holds</source>
            <translation>no longer holds</translation>
        </message>
        <message>
            <source>Nothing was measured.</source>
            <translation>Nothing was measured.</translation>
        </message>
        <message>
            <source>Part %1, lot %2</source>
            <translation>Part %1, lot %2</translation>
        </message>
        <message>
            <source>No serial number</source>
            <translation>No serial number</translation>
        </message>
        <message>
            <source>Serial number %1</source>
            <translation>Serial number %1</translation>
        </message>
        <message>
            <source>cut in %1 s</source>
            <translation>cut in %1 s</translation>
        </message>
        <message>
            <source>finished</source>
            <translation>finished</translation>
        </message>
        <message>
            <source>aborted</source>
            <translation>aborted</translation>
        </message>
        <message>
            <source>The estimator noticed a process change with this part.</source>
            <translation>The estimator noticed a process change with this part.</translation>
        </message>
        <message>
            <source>Kerf %1, written %2</source>
            <translation>Kerf %1, written %2</translation>
        </message>
        <message>
            <source>Verdict: %1</source>
            <translation>Verdict: %1</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <comment>limits</comment>
            <translation>%1 to %2</translation>
        </message>
        <message>
            <source>Decided: %1, by %2, %3</source>
            <translation>Decided: %1, by %2, %3</translation>
        </message>
        <message>
            <source>Nobody has decided yet what is done with it.</source>
            <translation>Nobody has decided yet what is done with it.</translation>
        </message>
        <message>
            <source>Part %1</source>
            <translation>Part %1</translation>
        </message>
    </context>
    <context>
    <name>People</name>
        <message>
            <source>No PIN</source>
            <translation>No PIN</translation>
        </message>
        <message>
            <source>Has a PIN</source>
            <translation>Has a PIN</translation>
        </message>
        <message>
            <source>PIN of %1</source>
            <translation>PIN of %1</translation>
        </message>
        <message>
            <source>%1 to %2 digits; nothing asks for none.</source>
            <translation>%1 to %2 digits; nothing asks for none.</translation>
        </message>
        <message>
            <source>A PIN has %1 to %2 digits.</source>
            <translation>A PIN has %1 to %2 digits.</translation>
        </message>
        <message>
            <source>People at this machine</source>
            <translation>People at this machine</translation>
        </message>
        <message>
            <source>Operators enter and correct diameters. Setters also open lots and switch loops. Process engineers also change recipes, limits and this list.</source>
            <translation>Operators enter and correct diameters. Setters also open lots and switch loops. Process engineers also change recipes, limits and this list.</translation>
        </message>
        <message>
            <source>Sign off when nobody has touched anything for</source>
            <translation>Sign off when nobody has touched anything for</translation>
        </message>
        <message>
            <source>never</source>
            <translation>never</translation>
        </message>
        <message>
            <source>%1 min</source>
            <translation>%1 min</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>Who may do what</source>
            <translation>Who may do what</translation>
        </message>
        <message>
            <source>Each role may do what the ones before it may. Starting a part, HOLD ALL and its release, and ending a tap ask for no name.</source>
            <translation>Each role may do what the ones before it may. Starting a part, HOLD ALL and its release, and ending a tap ask for no name.</translation>
        </message>
        <message>
            <source>what</source>
            <translation>what</translation>
        </message>
        <message>
            <source>from this role on</source>
            <translation>from this role on</translation>
        </message>
        <message>
            <source>reason</source>
            <translation>reason</translation>
        </message>
        <message>
            <source>must be given</source>
            <translation>must be given</translation>
        </message>
        <message>
            <source>Take off</source>
            <translation>Take off</translation>
        </message>
        <message>
            <source>Take %1 off the list?</source>
            <translation>Take %1 off the list?</translation>
        </message>
        <message>
            <source>What was done under this name keeps it. Who comes back signs on anew, as an operator.</source>
            <translation>What was done under this name keeps it. Who comes back signs on anew, as an operator.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
    </context>
    <context>
    <name>PinSheet</name>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
    </context>
    <context>
    <name>QualityTexts</name>
        <message>
            <source>Bore ⌀, %1</source>
            <translation>Bore ⌀, %1</translation>
        </message>
        <message>
            <source>n %1</source>
            <translation>n %1</translation>
        </message>
        <message>
            <source>%1 %2 (%3 to %4)</source>
            <comment>index with its interval</comment>
            <translation>%1 %2 (%3 to %4)</translation>
        </message>
        <message>
            <source>preliminary</source>
            <translation>preliminary</translation>
        </message>
        <message>
            <source>tool from part %1</source>
            <translation>tool from part %1</translation>
        </message>
        <message>
            <source>entered by %1</source>
            <translation>entered by %1</translation>
        </message>
        <message>
            <source>read from the gauge</source>
            <translation>read from the gauge</translation>
        </message>
        <message>
            <source>typed on the keypad</source>
            <translation>typed on the keypad</translation>
        </message>
        <message>
            <source>read from gauge %1</source>
            <translation>read from gauge %1</translation>
        </message>
        <message>
            <source>from file %1</source>
            <translation>from file %1</translation>
        </message>
        <message>
            <source>lot %1</source>
            <translation>lot %1</translation>
        </message>
    </context>
    <context>
    <name>Restore</name>
        <message>
            <source>Not restored</source>
            <translation>Not restored</translation>
        </message>
        <message>
            <source>The backup is whole and waits</source>
            <translation>The backup is whole and waits</translation>
        </message>
        <message>
            <source>It takes the place of the data at the next start of Kerf. What is stored until then goes aside with the data that are there now.</source>
            <translation>It takes the place of the data at the next start of Kerf. What is stored until then goes aside with the data that are there now.</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>Later</translation>
        </message>
        <message>
            <source>End Kerf now</source>
            <translation>End Kerf now</translation>
        </message>
        <message>
            <source>Put this backup in the place of the data?</source>
            <translation>Put this backup in the place of the data?</translation>
        </message>
        <message>
            <source>%1, of %2. Everything stored since then goes aside into a file of its own, nothing is deleted.</source>
            <translation>%1, of %2. Everything stored since then goes aside into a file of its own, nothing is deleted.</translation>
        </message>
        <message>
            <source>Why</source>
            <translation>Why</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Check it and lay it ready</source>
            <translation>Check it and lay it ready</translation>
        </message>
        <message>
            <source>Restore a backup</source>
            <translation>Restore a backup</translation>
        </message>
        <message>
            <source>No backup lies on a removable drive, among the documents or in the backups folder of the data.</source>
            <translation>No backup lies on a removable drive, among the documents or in the backups folder of the data.</translation>
        </message>
        <message>
            <source>Touch the one that shall take the place of the data; it is checked first.</source>
            <translation>Touch the one that shall take the place of the data; it is checked first.</translation>
        </message>
        <message>
            <source>The backup is whole and takes the place of the data at the next start.</source>
            <translation>The backup is whole and takes the place of the data at the next start.</translation>
        </message>
        <message>
            <source>Not restored: %1</source>
            <translation>Not restored: %1</translation>
        </message>
        <message>
            <source>It is being checked …</source>
            <translation>It is being checked …</translation>
        </message>
    </context>
    <context>
    <name>Revisions</name>
        <message>
            <source>and %1 more values</source>
            <translation>and %1 more values</translation>
        </message>
        <message>
            <source>The same values as now.</source>
            <translation>The same values as now.</translation>
        </message>
        <message>
            <source>Rev.</source>
            <translation>Rev.</translation>
        </message>
        <message>
            <source>When, by</source>
            <translation>When, by</translation>
        </message>
        <message>
            <source>Why</source>
            <translation>Why</translation>
        </message>
        <message>
            <source>back to %1: %2</source>
            <comment>revision, reason</comment>
            <translation>back to %1: %2</translation>
        </message>
        <message>
            <source>Revisions of %1</source>
            <translation>Revisions of %1</translation>
        </message>
        <message>
            <source>Nothing was changed yet.</source>
            <translation>Nothing was changed yet.</translation>
        </message>
        <message>
            <source>The first one holds. Touch an older one to compare it.</source>
            <translation>The first one holds. Touch an older one to compare it.</translation>
        </message>
        <message>
            <source>Reason for the change</source>
            <translation>Reason for the change</translation>
        </message>
        <message>
            <source>Roll back to it</source>
            <translation>Roll back to it</translation>
        </message>
        <message>
            <source>touch an older revision</source>
            <translation>touch an older revision</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>give a reason</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>The revision is back.</source>
            <translation>The revision is back.</translation>
        </message>
        <message>
            <source>Earlier revisions</source>
            <translation>Earlier revisions</translation>
        </message>
        <message>
            <source>%1, lower limit</source>
            <translation>%1, lower limit</translation>
        </message>
        <message>
            <source>%1, upper limit</source>
            <translation>%1, upper limit</translation>
        </message>
        <message>
            <source>none</source>
            <comment>limit</comment>
            <translation>none</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>yes</translation>
        </message>
        <message>
            <source>no</source>
            <translation>no</translation>
        </message>
    </context>
    <context>
    <name>Settings</name>
        <message>
            <source>Settings</source>
            <translation>Settings</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>Language</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Length</translation>
        </message>
        <message>
            <source>Temperature</source>
            <translation>Temperature</translation>
        </message>
        <message>
            <source>Theme</source>
            <translation>Theme</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Size</translation>
        </message>
        <message>
            <source>inch</source>
            <translation>inch</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>Light</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>Dark</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>Figures in</source>
            <translation>Figures in</translation>
        </message>
        <message>
            <source>Shop words</source>
            <translation>Shop words</translation>
        </message>
        <message>
            <source>Symbols</source>
            <translation>Symbols</translation>
        </message>
    </context>
    <context>
    <name>Shift</name>
        <message>
            <source>no reason given yet</source>
            <translation>no reason given yet</translation>
        </message>
        <message>
            <source>Setting up</source>
            <translation>Setting up</translation>
        </message>
        <message>
            <source>Tool change</source>
            <translation>Tool change</translation>
        </message>
        <message>
            <source>No material</source>
            <translation>No material</translation>
        </message>
        <message>
            <source>Measuring</source>
            <translation>Measuring</translation>
        </message>
        <message>
            <source>Fault, repair</source>
            <translation>Fault, repair</translation>
        </message>
        <message>
            <source>Cleaning, chips</source>
            <translation>Cleaning, chips</translation>
        </message>
        <message>
            <source>No order</source>
            <translation>No order</translation>
        </message>
        <message>
            <source>Break, nobody there</source>
            <translation>Break, nobody there</translation>
        </message>
        <message>
            <source>Something else</source>
            <translation>Something else</translation>
        </message>
        <message>
            <source>%1 made</source>
            <translation>%1 made</translation>
        </message>
        <message>
            <source>%1 good</source>
            <translation>%1 good</translation>
        </message>
        <message>
            <source>%1 rework</source>
            <translation>%1 rework</translation>
        </message>
        <message>
            <source>%1 scrap</source>
            <translation>%1 scrap</translation>
        </message>
        <message>
            <source>%1 not judged</source>
            <translation>%1 not judged</translation>
        </message>
        <message>
            <source>%1 broken off</source>
            <translation>%1 broken off</translation>
        </message>
        <message>
            <source>%1 min in the cut</source>
            <translation>%1 min in the cut</translation>
        </message>
        <message numerus="yes">
            <source>%1 min saved in %n milled parts against the planned feed.</source>
            <translation>
                <numerusform>%1 min saved in %n milled part against the planned feed.</numerusform>
                <numerusform>%1 min saved in %n milled parts against the planned feed.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 of %n bores are inside the tolerance that the recipe's first feed would have put outside.</source>
            <translation>
                <numerusform>%1 of %n bore is inside the tolerance that the recipe's first feed would have put outside.</numerusform>
                <numerusform>%1 of %n bores are inside the tolerance that the recipe's first feed would have put outside.</numerusform>
            </translation>
        </message>
        <message>
            <source>What the loops have saved is computed from milled parts and measured bores.</source>
            <translation>What the loops have saved is computed from milled parts and measured bores.</translation>
        </message>
        <message>
            <source>change announced</source>
            <translation>change announced</translation>
        </message>
        <message>
            <source>tool and material of a lot named</source>
            <translation>tool and material of a lot named</translation>
        </message>
        <message>
            <source>lot left out of memory or taken in</source>
            <translation>lot left out of memory or taken in</translation>
        </message>
        <message>
            <source>controller chosen</source>
            <translation>controller chosen</translation>
        </message>
        <message>
            <source>part out of tolerance dealt with</source>
            <translation>part out of tolerance dealt with</translation>
        </message>
        <message>
            <source>limits of the figures</source>
            <translation>limits of the figures</translation>
        </message>
        <message>
            <source>gap sensors read</source>
            <translation>gap sensors read</translation>
        </message>
        <message>
            <source>gap sensors set to zero</source>
            <translation>gap sensors set to zero</translation>
        </message>
        <message>
            <source>gauge registered</source>
            <translation>gauge registered</translation>
        </message>
        <message>
            <source>gauge study made</source>
            <translation>gauge study made</translation>
        </message>
        <message>
            <source>model put live</source>
            <translation>model put live</translation>
        </message>
        <message>
            <source>sensors placed</source>
            <translation>sensors placed</translation>
        </message>
        <message>
            <source>session recorded</source>
            <translation>session recorded</translation>
        </message>
        <message>
            <source>setup changed</source>
            <translation>setup changed</translation>
        </message>
        <message>
            <source>new tool</source>
            <translation>new tool</translation>
        </message>
        <message>
            <source>tool life set</source>
            <translation>tool life set</translation>
        </message>
        <message>
            <source>tool left out of memory or taken in</source>
            <translation>tool left out of memory or taken in</translation>
        </message>
        <message>
            <source>tuning accepted</source>
            <translation>tuning accepted</translation>
        </message>
        <message>
            <source>Account changed</source>
            <translation>Account changed</translation>
        </message>
        <message>
            <source>Account made</source>
            <translation>Account made</translation>
        </message>
        <message>
            <source>Alarm acknowledged</source>
            <translation>Alarm acknowledged</translation>
        </message>
        <message>
            <source>Diameter corrected</source>
            <translation>Diameter corrected</translation>
        </message>
        <message>
            <source>Lot closed</source>
            <translation>Lot closed</translation>
        </message>
        <message>
            <source>Lot opened</source>
            <translation>Lot opened</translation>
        </message>
        <message>
            <source>Diameter entered</source>
            <translation>Diameter entered</translation>
        </message>
        <message>
            <source>Measured origin taken over</source>
            <translation>Measured origin taken over</translation>
        </message>
        <message>
            <source>Origin measured</source>
            <translation>Origin measured</translation>
        </message>
        <message>
            <source>Recipe rolled back</source>
            <translation>Recipe rolled back</translation>
        </message>
        <message>
            <source>Recipe saved</source>
            <translation>Recipe saved</translation>
        </message>
        <message>
            <source>Thermal reference taken</source>
            <translation>Thermal reference taken</translation>
        </message>
        <message>
            <source>Thermal reference taken, shift back to zero</source>
            <translation>Thermal reference taken, shift back to zero</translation>
        </message>
        <message>
            <source>Refused for want of rights</source>
            <translation>Refused for want of rights</translation>
        </message>
        <message>
            <source>Feed schedule accepted</source>
            <translation>Feed schedule accepted</translation>
        </message>
        <message>
            <source>Serial number set</source>
            <translation>Serial number set</translation>
        </message>
        <message>
            <source>Setting changed:</source>
            <translation>Setting changed:</translation>
        </message>
        <message>
            <source>Wrong PIN</source>
            <translation>Wrong PIN</translation>
        </message>
        <message>
            <source>PIN removed:</source>
            <translation>PIN removed:</translation>
        </message>
        <message>
            <source>PIN set:</source>
            <translation>PIN set:</translation>
        </message>
        <message>
            <source>First process engineer made</source>
            <translation>First process engineer made</translation>
        </message>
        <message>
            <source>Role set:</source>
            <translation>Role set:</translation>
        </message>
        <message>
            <source>Diameter taken out</source>
            <translation>Diameter taken out</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>no lot selected any more</source>
            <translation>no lot selected any more</translation>
        </message>
        <message>
            <source>lot selected</source>
            <translation>lot selected</translation>
        </message>
        <message>
            <source>Account removed</source>
            <translation>Account removed</translation>
        </message>
        <message>
            <source>Second person:</source>
            <translation>Second person:</translation>
        </message>
        <message>
            <source>operator</source>
            <translation>operator</translation>
        </message>
        <message>
            <source>setter</source>
            <translation>setter</translation>
        </message>
        <message>
            <source>process engineer</source>
            <translation>process engineer</translation>
        </message>
        <message>
            <source>no PIN</source>
            <translation>no PIN</translation>
        </message>
        <message>
            <source>PIN</source>
            <translation>PIN</translation>
        </message>
        <message>
            <source>new PIN</source>
            <translation>new PIN</translation>
        </message>
        <message>
            <source>part left out of memory or taken in</source>
            <translation>part left out of memory or taken in</translation>
        </message>
    </context>
    <context>
    <name>ShiftReport</name>
        <message numerus="yes">
            <source>and %n more</source>
            <translation>
                <numerusform>and %n more</numerusform>
                <numerusform>and %n more</numerusform>
            </translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>Shift</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1 to %2</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Parts</translation>
        </message>
        <message>
            <source>No part was finished.</source>
            <translation>No part was finished.</translation>
        </message>
        <message numerus="yes">
            <source>%n minutes</source>
            <translation>
                <numerusform>%n minute</numerusform>
                <numerusform>%n minutes</numerusform>
            </translation>
        </message>
        <message>
            <source>Stops</source>
            <translation>Stops</translation>
        </message>
        <message>
            <source>Nothing stood longer than three minutes.</source>
            <translation>Nothing stood longer than three minutes.</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>Changes</translation>
        </message>
        <message>
            <source>Nothing was changed.</source>
            <translation>Nothing was changed.</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>Alarms</translation>
        </message>
        <message>
            <source>No alarm came.</source>
            <translation>No alarm came.</translation>
        </message>
        <message>
            <source>Notes</source>
            <translation>Notes</translation>
        </message>
        <message>
            <source>No note was left.</source>
            <translation>No note was left.</translation>
        </message>
        <message>
            <source>Handed over: ____________________</source>
            <translation>Handed over: ____________________</translation>
        </message>
        <message>
            <source>Taken over: ____________________</source>
            <translation>Taken over: ____________________</translation>
        </message>
    </context>
    <context>
    <name>ShopText</name>
        <message>
            <source>%1 s ago</source>
            <translation>%1 s ago</translation>
        </message>
        <message>
            <source>%1 min ago</source>
            <translation>%1 min ago</translation>
        </message>
        <message>
            <source>%1 h ago</source>
            <translation>%1 h ago</translation>
        </message>
        <message>
            <source>The shop's database is not prepared for consoles.</source>
            <translation>The shop's database is not prepared for consoles.</translation>
        </message>
        <message>
            <source>The shop does not let this console in: enrol it.</source>
            <translation>The shop does not let this console in: enrol it.</translation>
        </message>
        <message>
            <source>This console is newer than the shop: bring the shop up to date.</source>
            <translation>This console is newer than the shop: bring the shop up to date.</translation>
        </message>
        <message>
            <source>The data file cannot be read for the shop.</source>
            <translation>The data file cannot be read for the shop.</translation>
        </message>
        <message>
            <source>The shop's address cannot be used.</source>
            <translation>The shop's address cannot be used.</translation>
        </message>
        <message>
            <source>The shop is out of reach.</source>
            <translation>The shop is out of reach.</translation>
        </message>
        <message>
            <source>%1 entries wait here; nothing is lost.</source>
            <translation>%1 entries wait here; nothing is lost.</translation>
        </message>
        <message>
            <source>Everything is in the shop.</source>
            <translation>Everything is in the shop.</translation>
        </message>
        <message>
            <source>The shop is being called.</source>
            <translation>The shop is being called.</translation>
        </message>
        <message>
            <source>%1 entries were put aside there: have them looked at.</source>
            <translation>%1 entries were put aside there: have them looked at.</translation>
        </message>
        <message>
            <source>Last contact %1.</source>
            <comment>an age</comment>
            <translation>Last contact %1.</translation>
        </message>
    </context>
    <context>
    <name>SourceTexts</name>
        <message>
            <source>typed</source>
            <translation>typed</translation>
        </message>
        <message>
            <source>gauge</source>
            <translation>gauge</translation>
        </message>
        <message>
            <source>gauge %1</source>
            <translation>gauge %1</translation>
        </message>
        <message>
            <source>file %1</source>
            <translation>file %1</translation>
        </message>
    </context>
    <context>
    <name>StartObstacle</name>
        <message>
            <source>No link to the machine.</source>
            <translation>No link to the machine.</translation>
        </message>
        <message>
            <source>Emergency stop is pressed.</source>
            <translation>Emergency stop is pressed.</translation>
        </message>
        <message>
            <source>The machine is off.</source>
            <translation>The machine is off.</translation>
        </message>
        <message>
            <source>Hold is in force.</source>
            <translation>Hold is in force.</translation>
        </message>
        <message>
            <source>A stop stands: look at the machine, then release it.</source>
            <translation>A stop stands: look at the machine, then release it.</translation>
        </message>
        <message>
            <source>Start the program at the control.</source>
            <translation>Start the program at the control.</translation>
        </message>
        <message>
            <source>Finished parts are not stored yet.</source>
            <translation>Finished parts are not stored yet.</translation>
        </message>
        <message>
            <source>A part is being cut.</source>
            <translation>A part is being cut.</translation>
        </message>
        <message>
            <source>The machine is busy: %1.</source>
            <translation>The machine is busy: %1.</translation>
        </message>
    </context>
    <context>
    <name>StartRest</name>
        <message>
            <source>Loading what was just stored.</source>
            <translation>Loading what was just stored.</translation>
        </message>
    </context>
    <context>
    <name>TappingTexts</name>
        <message>
            <source>%1, %2 rpm, %3 rev, gear %4</source>
            <comment>thread, speed, depth, gear</comment>
            <translation>%1, %2 rpm, %3 rev, gear %4</translation>
        </message>
        <message>
            <source>not tuned</source>
            <translation>not tuned</translation>
        </message>
        <message>
            <source>tuned</source>
            <translation>tuned</translation>
        </message>
        <message>
            <source>air tap</source>
            <translation>air tap</translation>
        </message>
        <message>
            <source>trial %1</source>
            <translation>trial %1</translation>
        </message>
        <message>
            <source>tuned, to be accepted</source>
            <translation>tuned, to be accepted</translation>
        </message>
        <message>
            <source>proposal</source>
            <translation>proposal</translation>
        </message>
        <message>
            <source>accepted</source>
            <translation>accepted</translation>
        </message>
        <message>
            <source>rolled back</source>
            <translation>rolled back</translation>
        </message>
        <message>
            <source>tuning ended</source>
            <translation>tuning ended</translation>
        </message>
        <message>
            <source>The machine's own gains: nothing is stored for this job.</source>
            <translation>The machine's own gains: nothing is stored for this job.</translation>
        </message>
        <message>
            <source>Gains and trim of the stored tuning of this job.</source>
            <translation>Gains and trim of the stored tuning of this job.</translation>
        </message>
        <message>
            <source>Gains stored for this speed range; the trim does not fit: tune before production.</source>
            <translation>Gains stored for this speed range; the trim does not fit: tune before production.</translation>
        </message>
        <message>
            <source>Gains of this tuning.</source>
            <translation>Gains of this tuning.</translation>
        </message>
        <message>
            <source>sum of errors %1 → %2 (−%3 %), in the work %4 → %5 p-p</source>
            <translation>sum of errors %1 → %2 (−%3 %), in the work %4 → %5 p-p</translation>
        </message>
        <message>
            <source>Rolled back by %1; the tuning had: %2.</source>
            <translation>Rolled back by %1; the tuning had: %2.</translation>
        </message>
        <message>
            <source>Before and after, accepted by %1: %2.</source>
            <translation>Before and after, accepted by %1: %2.</translation>
        </message>
    </context>
    <context>
    <name>ThermalSheets</name>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>The model that is live</source>
            <translation>The model that is live</translation>
        </message>
        <message>
            <source>what</source>
            <translation>what</translation>
        </message>
        <message>
            <source>value</source>
            <translation>value</translation>
        </message>
        <message>
            <source>Back to the model before</source>
            <translation>Back to the model before</translation>
        </message>
        <message>
            <source>there is no model before this</source>
            <translation>there is no model before this</translation>
        </message>
        <message>
            <source>Train a new one</source>
            <translation>Train a new one</translation>
        </message>
        <message>
            <source>model</source>
            <translation>model</translation>
        </message>
        <message>
            <source>the first one is being trained</source>
            <translation>the first one is being trained</translation>
        </message>
        <message>
            <source>none yet</source>
            <translation>none yet</translation>
        </message>
        <message>
            <source>%1, no. %2</source>
            <translation>%1, no. %2</translation>
        </message>
        <message>
            <source>error on days left out, X / Y / Z</source>
            <translation>error on days left out, X / Y / Z</translation>
        </message>
        <message>
            <source>error on its own check rows, X / Y / Z</source>
            <translation>error on its own check rows, X / Y / Z</translation>
        </message>
        <message>
            <source>rms %1, worst %2 %3</source>
            <translation>rms %1, worst %2 %3</translation>
        </message>
        <message>
            <source>live since</source>
            <translation>live since</translation>
        </message>
        <message>
            <source>%1, %2 h ago, by %3</source>
            <translation>%1, %2 h ago, by %3</translation>
        </message>
        <message>
            <source>thermocouples</source>
            <translation>thermocouples</translation>
        </message>
        <message>
            <source>trained on</source>
            <translation>trained on</translation>
        </message>
        <message>
            <source>%1 (%2 rows)</source>
            <translation>%1 (%2 rows)</translation>
        </message>
        <message>
            <source>formula</source>
            <translation>formula</translation>
        </message>
        <message>
            <source>file</source>
            <translation>file</translation>
        </message>
        <message>
            <source>recorded here</source>
            <translation>recorded here</translation>
        </message>
        <message>
            <source>built-in simulation</source>
            <translation>built-in simulation</translation>
        </message>
        <message>
            <source>Train a model</source>
            <translation>Train a model</translation>
        </message>
        <message>
            <source>Touch the days to train on. Several days of different work make a model that also holds on days it has not seen. History files belong in %1.</source>
            <translation>Touch the days to train on. Several days of different work make a model that also holds on days it has not seen. History files belong in %1.</translation>
        </message>
        <message>
            <source>use</source>
            <translation>use</translation>
        </message>
        <message>
            <source>day</source>
            <translation>day</translation>
        </message>
        <message>
            <source>from</source>
            <translation>from</translation>
        </message>
        <message>
            <source>rms X / Y / Z, %1</source>
            <translation>rms X / Y / Z, %1</translation>
        </message>
        <message>
            <source>worst X / Y / Z</source>
            <translation>worst X / Y / Z</translation>
        </message>
        <message>
            <source>Cancel training</source>
            <translation>Cancel training</translation>
        </message>
        <message>
            <source>Train and compare</source>
            <translation>Train and compare</translation>
        </message>
        <message>
            <source>Go live</source>
            <translation>Go live</translation>
        </message>
        <message>
            <source>nothing is being trained</source>
            <translation>nothing is being trained</translation>
        </message>
        <message>
            <source>a model is being trained</source>
            <translation>a model is being trained</translation>
        </message>
        <message>
            <source>choose days first</source>
            <translation>choose days first</translation>
        </message>
        <message>
            <source>train one first</source>
            <translation>train one first</translation>
        </message>
        <message>
            <source>The comparison appears below after the training.</source>
            <translation>The comparison appears below after the training.</translation>
        </message>
        <message>
            <source>Training: %1 %</source>
            <translation>Training: %1 %</translation>
        </message>
        <message>
            <source>Errors on days left out of the training. The live model goes on until you go live.</source>
            <translation>Errors on days left out of the training. The live model goes on until you go live.</translation>
        </message>
        <message>
            <source>Cancelled; nothing has changed.</source>
            <translation>Cancelled; nothing has changed.</translation>
        </message>
        <message>
            <source>%1: best</source>
            <translation>%1: best</translation>
        </message>
        <message>
            <source>Measure the origin</source>
            <translation>Measure the origin</translation>
        </message>
        <message>
            <source>axis</source>
            <translation>axis</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>measured</translation>
        </message>
        <message>
            <source>predicted</source>
            <translation>predicted</translation>
        </message>
        <message>
            <source>difference</source>
            <translation>difference</translation>
        </message>
        <message>
            <source>verdict</source>
            <translation>verdict</translation>
        </message>
        <message>
            <source>New reference</source>
            <translation>New reference</translation>
        </message>
        <message>
            <source>Take over</source>
            <translation>Take over</translation>
        </message>
        <message>
            <source>Measure now</source>
            <translation>Measure now</translation>
        </message>
        <message>
            <source>the gap sensors read nothing</source>
            <translation>the gap sensors read nothing</translation>
        </message>
        <message>
            <source>take a reference first</source>
            <translation>take a reference first</translation>
        </message>
        <message>
            <source>being measured</source>
            <translation>being measured</translation>
        </message>
        <message>
            <source>measure first</source>
            <translation>measure first</translation>
        </message>
        <message>
            <source>Count from now on?</source>
            <translation>Count from now on?</translation>
        </message>
        <message>
            <source>The machine must be as cold as it is at the start of a day, and the origin set anew. The shift goes back to zero.</source>
            <translation>The machine must be as cold as it is at the start of a day, and the origin set anew. The shift goes back to zero.</translation>
        </message>
        <message>
            <source>Leave it</source>
            <translation>Leave it</translation>
        </message>
        <message>
            <source>Count from now on</source>
            <translation>Count from now on</translation>
        </message>
        <message>
            <source>End the session</source>
            <translation>End the session</translation>
        </message>
        <message>
            <source>Record a session</source>
            <translation>Record a session</translation>
        </message>
        <message>
            <source>1. End the program. 2. Put the test bar in the spindle and move it between the three gap sensors. 3. Measure: five readings take five seconds.</source>
            <translation>1. End the program. 2. Put the test bar in the spindle and move it between the three gap sensors. 3. Measure: five readings take five seconds.</translation>
        </message>
        <message numerus="yes">
            <source>Recording: %n minutes measured. Let the spindle run as in a day's work; several hours make a good day.</source>
            <translation>
                <numerusform>Recording: %n minute measured. Let the spindle run as in a day's work; several hours make a good day.</numerusform>
                <numerusform>Recording: %n minutes measured. Let the spindle run as in a day's work; several hours make a good day.</numerusform>
            </translation>
        </message>
        <message>
            <source>Measuring …</source>
            <translation>Measuring …</translation>
        </message>
        <message>
            <source>Measured. If the difference is outside the interval on a machine that is warm, take it over and train again with this state.</source>
            <translation>Measured. If the difference is outside the interval on a machine that is warm, take it over and train again with this state.</translation>
        </message>
        <message>
            <source>inside the interval</source>
            <translation>inside the interval</translation>
        </message>
        <message>
            <source>outside the interval</source>
            <translation>outside the interval</translation>
        </message>
        <message>
            <source>Shifts and measurements</source>
            <translation>Shifts and measurements</translation>
        </message>
        <message>
            <source>time</source>
            <translation>time</translation>
        </message>
        <message>
            <source>shift X / Y / Z, %1</source>
            <translation>shift X / Y / Z, %1</translation>
        </message>
        <message>
            <source>drift X / Y / Z</source>
            <translation>drift X / Y / Z</translation>
        </message>
        <message>
            <source>measured X / Y / Z, %1</source>
            <translation>measured X / Y / Z, %1</translation>
        </message>
        <message>
            <source>predicted X / Y / Z</source>
            <translation>predicted X / Y / Z</translation>
        </message>
        <message>
            <source>Each change of the shift appears here.</source>
            <translation>Each change of the shift appears here.</translation>
        </message>
        <message>
            <source>Each measurement of the origin appears here.</source>
            <translation>Each measurement of the origin appears here.</translation>
        </message>
        <message>
            <source>Thermocouples</source>
            <translation>Thermocouples</translation>
        </message>
        <message>
            <source>Sick ones first, then the model's own.</source>
            <translation>Sick ones first, then the model's own.</translation>
        </message>
        <message>
            <source>thermocouple</source>
            <translation>thermocouple</translation>
        </message>
        <message>
            <source>temperature</source>
            <translation>temperature</translation>
        </message>
        <message>
            <source>state</source>
            <translation>state</translation>
        </message>
        <message>
            <source>used</source>
            <translation>used</translation>
        </message>
        <message>
            <source>Error over the work space</source>
            <translation>Error over the work space</translation>
        </message>
        <message>
            <source>From the machine's measured error elements, against the corner X0 Y0 of the table; the darker the larger. Independent of the drift with time.</source>
            <translation>From the machine's measured error elements, against the corner X0 Y0 of the table; the darker the larger. Independent of the drift with time.</translation>
        </message>
        <message>
            <source>The error elements of this machine have not been measured.</source>
            <translation>The error elements of this machine have not been measured.</translation>
        </message>
        <message>
            <source>Exact, at Z %1; the first-order formula differs by at most %2.</source>
            <translation>Exact, at Z %1; the first-order formula differs by at most %2.</translation>
        </message>
        <message>
            <source>Limits and warm-up</source>
            <translation>Limits and warm-up</translation>
        </message>
        <message>
            <source>Use</source>
            <translation>Use</translation>
        </message>
        <message>
            <source>the model learns from every measurement by itself</source>
            <translation>the model learns from every measurement by itself</translation>
        </message>
        <message>
            <source>Measured and learnt from. Today differs from the days trained on: measure every hour.</source>
            <translation>Measured and learnt from. Today differs from the days trained on: measure every hour.</translation>
        </message>
        <message>
            <source>Measured and learnt from: the coefficients of today follow from the next minute on.</source>
            <translation>Measured and learnt from: the coefficients of today follow from the next minute on.</translation>
        </message>
        <message>
            <source>Reason for the change</source>
            <translation>Reason for the change</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>give a reason</translation>
        </message>
        <message>
            <source>The last part as a measurement</source>
            <translation>The last part as a measurement</translation>
        </message>
        <message>
            <source>A good part carries what was left of the drift when it was finished. Enter by how much it is off, at the temperature it was cut at; leave empty what was not measured. Each part counts once.</source>
            <translation>A good part carries what was left of the drift when it was finished. Enter by how much it is off, at the temperature it was cut at; leave empty what was not measured. Each part counts once.</translation>
        </message>
        <message>
            <source>Take as a measurement</source>
            <translation>Take as a measurement</translation>
        </message>
        <message>
            <source>no part finished since the reference</source>
            <translation>no part finished since the reference</translation>
        </message>
        <message>
            <source>enter what was measured</source>
            <translation>enter what was measured</translation>
        </message>
        <message>
            <source>A part is finished that has not been measured yet.</source>
            <translation>A part is finished that has not been measured yet.</translation>
        </message>
        <message>
            <source>There is no finished part to measure: cut one, then measure it.</source>
            <translation>There is no finished part to measure: cut one, then measure it.</translation>
        </message>
        <message>
            <source>By a measured part</source>
            <translation>By a measured part</translation>
        </message>
        <message>
            <source>%1, part</source>
            <translation>%1, part</translation>
        </message>
        <message>
            <source>The shift moves only between parts</source>
            <translation>The shift moves only between parts</translation>
        </message>
        <message>
            <source>The shift follows while a part is cut</source>
            <translation>The shift follows while a part is cut</translation>
        </message>
        <message>
            <source>left in a part</source>
            <translation>left in a part</translation>
        </message>
        <message>
            <source>The new limits are stored and hold from now on.</source>
            <translation>The new limits are stored and hold from now on.</translation>
        </message>
        <message>
            <source>Left out by %1: %2</source>
            <translation>Left out by %1: %2</translation>
        </message>
        <message>
            <source>out</source>
            <translation>out</translation>
        </message>
        <message>
            <source>Reason to leave the touched day out, or to take it in again</source>
            <translation>Reason to leave the touched day out, or to take it in again</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>Take in again</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>Leave out</translation>
        </message>
        <message>
            <source>touch a day first</source>
            <translation>touch a day first</translation>
        </message>
    </context>
    <context>
    <name>ThermalTexts</name>
        <message>
            <source>healthy</source>
            <translation>healthy</translation>
        </message>
        <message>
            <source>suspect</source>
            <translation>suspect</translation>
        </message>
        <message>
            <source>open</source>
            <translation>open</translation>
        </message>
        <message>
            <source>shorted</source>
            <translation>shorted</translation>
        </message>
        <message>
            <source>stuck</source>
            <translation>stuck</translation>
        </message>
        <message>
            <source>noisy</source>
            <translation>noisy</translation>
        </message>
        <message>
            <source>jumped away</source>
            <translation>jumped away</translation>
        </message>
        <message>
            <source>disagrees</source>
            <translation>disagrees</translation>
        </message>
        <message>
            <source>no reading</source>
            <translation>no reading</translation>
        </message>
        <message>
            <source>%1 min</source>
            <translation>%1 min</translation>
        </message>
        <message>
            <source>Ready for %1</source>
            <translation>Ready for %1</translation>
        </message>
        <message>
            <source>Ready for %1 in %2</source>
            <translation>Ready for %1 in %2</translation>
        </message>
        <message>
            <source>Interval wider than %1: measure the origin</source>
            <translation>Interval wider than %1: measure the origin</translation>
        </message>
        <message>
            <source>Warm-up: %1 left</source>
            <translation>Warm-up: %1 left</translation>
        </message>
        <message>
            <source>Readiness is known after 20 min of prediction</source>
            <translation>Readiness is known after 20 min of prediction</translation>
        </message>
        <message>
            <source>Drift, %1</source>
            <translation>Drift, %1</translation>
        </message>
        <message>
            <source>not judged</source>
            <translation>not judged</translation>
        </message>
        <message>
            <source>good, within %1</source>
            <translation>good, within %1</translation>
        </message>
        <message>
            <source>out of %1</source>
            <translation>out of %1</translation>
        </message>
    </context>
    <context>
    <name>ToolMemory</name>
        <message>
            <source>left out by %1: %2</source>
            <translation>left out by %1: %2</translation>
        </message>
        <message>
            <source>Tools before</source>
            <translation>Tools before</translation>
        </message>
        <message>
            <source>A new tool begins from tools of its radius and flutes. There are none yet.</source>
            <translation>A new tool begins from tools of its radius and flutes. There are none yet.</translation>
        </message>
        <message>
            <source>Reason</source>
            <translation>Reason</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>Take in again</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>Leave out</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>%1, %2 parts: %3 %4 N/mm, %5 %6</source>
            <comment>part type, parts, two figures of a tool with their names</comment>
            <translation>%1, %2 parts: %3 %4 N/mm, %5 %6</translation>
        </message>
        <message>
            <source>Begins from %1 tools before: %2 %3 N/mm (%4 to %5)</source>
            <comment>how many, name, value, interval</comment>
            <translation>Begins from %1 tools before: %2 %3 N/mm (%4 to %5)</translation>
        </message>
        <message>
            <source>, %1 %2 ± %3</source>
            <comment>name and value expected of the first part</comment>
            <translation>, %1 %2 ± %3</translation>
        </message>
        <message>
            <source>What tools before count for is kept.</source>
            <translation>What tools before count for is kept.</translation>
        </message>
    </context>
    <context>
    <name>Tools</name>
        <message>
            <source>%1 of %2 parts</source>
            <translation>%1 of %2 parts</translation>
        </message>
        <message>
            <source>%1 parts, no life is set</source>
            <translation>%1 parts, no life is set</translation>
        </message>
        <message>
            <source>changed %1 by %2</source>
            <translation>changed %1 by %2</translation>
        </message>
        <message>
            <source>Life of the tool: %1</source>
            <translation>Life of the tool: %1</translation>
        </message>
        <message>
            <source>Parts that a tool is used for. At nine tenths of them Kerf says so. 0: no life is set.</source>
            <translation>Parts that a tool is used for. At nine tenths of them Kerf says so. 0: no life is set.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>A life is a whole number of parts.</source>
            <translation>A life is a whole number of parts.</translation>
        </message>
        <message>
            <source>The life is kept.</source>
            <translation>The life is kept.</translation>
        </message>
        <message>
            <source>Keep it</source>
            <translation>Keep it</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Tools</translation>
        </message>
        <message>
            <source>Parts are counted from the last change. Say so when a new tool or insert is in: wear and what the loop has learnt of the old one end with it.</source>
            <translation>Parts are counted from the last change. Say so when a new tool or insert is in: wear and what the loop has learnt of the old one end with it.</translation>
        </message>
        <message>
            <source>Life</source>
            <translation>Life</translation>
        </message>
        <message>
            <source>New tool</source>
            <translation>New tool</translation>
        </message>
        <message>
            <source>A new tool is in: its parts are counted from here.</source>
            <translation>A new tool is in: its parts are counted from here.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
    </context>
    <context>
    <name>TurningTexts</name>
        <message>
            <source>Open</source>
            <comment>turning controller</comment>
            <translation>Open</translation>
        </message>
        <message>
            <source>Paper's PI</source>
            <comment>turning controller</comment>
            <translation>Paper's PI</translation>
        </message>
        <message>
            <source>Tuned PI</source>
            <comment>turning controller</comment>
            <translation>Tuned PI</translation>
        </message>
        <message>
            <source>Tones</source>
            <comment>turning controller</comment>
            <translation>Tones</translation>
        </message>
        <message>
            <source>out of the cut</source>
            <translation>out of the cut</translation>
        </message>
        <message>
            <source>first revolution</source>
            <translation>first revolution</translation>
        </message>
        <message>
            <source>cutting</source>
            <translation>cutting</translation>
        </message>
        <message>
            <source>out of the loop</source>
            <translation>out of the loop</translation>
        </message>
        <message>
            <source>not cutting</source>
            <translation>not cutting</translation>
        </message>
        <message>
            <source>%1 deep, %2, %3 per revolution, tool radius %4</source>
            <comment>depth, speed, feed, radius</comment>
            <translation>%1 deep, %2, %3 per revolution, tool radius %4</translation>
        </message>
    </context>
    <context>
    <name>VerdictTexts</name>
        <message>
            <source>good</source>
            <translation>good</translation>
        </message>
        <message>
            <source>not judged</source>
            <translation>not judged</translation>
        </message>
        <message>
            <source>rework possible</source>
            <translation>rework possible</translation>
        </message>
        <message>
            <source>scrap</source>
            <translation>scrap</translation>
        </message>
    </context>
    <context>
    <name>Vocabulary</name>
        <message>
            <source>How the bar bends</source>
            <translation>How the bar bends</translation>
        </message>
        <message>
            <source>Estimated law</source>
            <translation>Estimated law</translation>
        </message>
        <message>
            <source>by feed</source>
            <translation>by feed</translation>
        </message>
        <message>
            <source>by overhang</source>
            <translation>by overhang</translation>
        </message>
        <message>
            <source>as a whole</source>
            <translation>as a whole</translation>
        </message>
        <message>
            <source>Tool: how hard it cuts, per part</source>
            <translation>Tool: how hard it cuts, per part</translation>
        </message>
        <message>
            <source>Tool: mean ln(C·b) per part</source>
            <translation>Tool: mean ln(C·b) per part</translation>
        </message>
        <message>
            <source>how hard it cuts</source>
            <translation>how hard it cuts</translation>
        </message>
        <message>
            <source>how hard it cuts now</source>
            <translation>how hard it cuts now</translation>
        </message>
        <message>
            <source>ln(C·b) now</source>
            <translation>ln(C·b) now</translation>
        </message>
        <message>
            <source>tool stiffness</source>
            <translation>tool stiffness</translation>
        </message>
        <message>
            <source>reserve before it swings, times</source>
            <translation>reserve before it swings, times</translation>
        </message>
        <message>
            <source>gain margin, times</source>
            <translation>gain margin, times</translation>
        </message>
        <message>
            <source>unevenness, on average</source>
            <translation>unevenness, on average</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>highest to lowest point</source>
            <translation>highest to lowest point</translation>
        </message>
        <message>
            <source>P-V of a revolution</source>
            <translation>P-V of a revolution</translation>
        </message>
        <message>
            <source>unevenness without the trim</source>
            <translation>unevenness without the trim</translation>
        </message>
        <message>
            <source>RMS without the trim</source>
            <translation>RMS without the trim</translation>
        </message>
        <message>
            <source>Reserves and trim</source>
            <translation>Reserves and trim</translation>
        </message>
        <message>
            <source>Loop margins and trim</source>
            <translation>Loop margins and trim</translation>
        </message>
        <message>
            <source>may be stronger, times</source>
            <translation>may be stronger, times</translation>
        </message>
        <message>
            <source>gain, times</source>
            <translation>gain, times</translation>
        </message>
        <message>
            <source>may be shifted by</source>
            <translation>may be shifted by</translation>
        </message>
        <message>
            <source>phase</source>
            <translation>phase</translation>
        </message>
        <message>
            <source>may come later by</source>
            <translation>may come later by</translation>
        </message>
        <message>
            <source>more delay</source>
            <translation>more delay</translation>
        </message>
        <message>
            <source>distance from ringing</source>
            <translation>distance from ringing</translation>
        </message>
        <message>
            <source>smallest |1 + L|</source>
            <translation>smallest |1 + L|</translation>
        </message>
        <message>
            <source>share of the last force</source>
            <translation>share of the last force</translation>
        </message>
        <message>
            <source>force of the depth now</source>
            <translation>force of the depth now</translation>
        </message>
        <message>
            <source>force of the depth before</source>
            <translation>force of the depth before</translation>
        </message>
        <message>
            <source>doubt, log</source>
            <translation>doubt, log</translation>
        </message>
        <message>
            <source>covariance, log</source>
            <translation>covariance, log</translation>
        </message>
        <message>
            <source>Drift of the origin, predicted</source>
            <translation>Drift of the origin, predicted</translation>
        </message>
        <message>
            <source>Drift δ̂ of the origin, ± 1.96 σ</source>
            <translation>Drift δ̂ of the origin, ± 1.96 σ</translation>
        </message>
        <message>
            <source>drift</source>
            <translation>drift</translation>
        </message>
        <message>
            <source>line: predicted, band: 95 % interval, dots: measured</source>
            <translation>line: predicted, band: 95 % interval, dots: measured</translation>
        </message>
        <message>
            <source>line: δ̂, band: ± 1.96 σ, dots: δ measured</source>
            <translation>line: δ̂, band: ± 1.96 σ, dots: δ measured</translation>
        </message>
        <message>
            <source>a few thermocouples, straight lines</source>
            <translation>a few thermocouples, straight lines</translation>
        </message>
        <message>
            <source>regression on few sensors</source>
            <translation>regression on few sensors</translation>
        </message>
        <message>
            <source>all days together, and today</source>
            <translation>all days together, and today</translation>
        </message>
        <message>
            <source>hierarchical over days</source>
            <translation>hierarchical over days</translation>
        </message>
        <message>
            <source>network of thermocouples</source>
            <translation>network of thermocouples</translation>
        </message>
        <message>
            <source>network, guarded</source>
            <translation>network, guarded</translation>
        </message>
        <message>
            <source>network, as first published</source>
            <translation>network, as first published</translation>
        </message>
        <message>
            <source>network, as printed</source>
            <translation>network, as printed</translation>
        </message>
        <message>
            <source>How spindle and Z are matched</source>
            <translation>How spindle and Z are matched</translation>
        </message>
        <message>
            <source>Gains</source>
            <translation>Gains</translation>
        </message>
        <message>
            <source>spindle, how firm, 1/s</source>
            <translation>spindle, how firm, 1/s</translation>
        </message>
        <message>
            <source>spindle Kp, 1/s</source>
            <translation>spindle Kp, 1/s</translation>
        </message>
        <message>
            <source>Z, how firm, 1/s</source>
            <translation>Z, how firm, 1/s</translation>
        </message>
        <message>
            <source>Z Kp, 1/s</source>
            <translation>Z Kp, 1/s</translation>
        </message>
        <message>
            <source>Z, ahead with speed</source>
            <translation>Z, ahead with speed</translation>
        </message>
        <message>
            <source>Z speed FF</source>
            <translation>Z speed FF</translation>
        </message>
        <message>
            <source>Z, ahead with accel.</source>
            <translation>Z, ahead with accel.</translation>
        </message>
        <message>
            <source>Z accel. FF</source>
            <translation>Z accel. FF</translation>
        </message>
        <message>
            <source>How far Z is off the thread, %1, over spindle revolutions in and out</source>
            <translation>How far Z is off the thread, %1, over spindle revolutions in and out</translation>
        </message>
        <message>
            <source>Contour error E_r, %1, over spindle revolutions in and out</source>
            <translation>Contour error E_r, %1, over spindle revolutions in and out</translation>
        </message>
        <message>
            <source>errors added up, %1</source>
            <translation>errors added up, %1</translation>
        </message>
        <message>
            <source>SAEC = Σ |E_r|, %1</source>
            <translation>SAEC = Σ |E_r|, %1</translation>
        </message>
        <message>
            <source>widest error in the work, %1</source>
            <translation>widest error in the work, %1</translation>
        </message>
        <message>
            <source>E_r p-p in the work, %1</source>
            <translation>E_r p-p in the work, %1</translation>
        </message>
    </context>
    <context>
    <name>Words</name>
        <message>
            <source>Alarm %1, which this console does not know</source>
            <translation>Alarm %1, which this console does not know</translation>
        </message>
        <message>
            <source>Note the number and call service.</source>
            <translation>Note the number and call service.</translation>
        </message>
        <message>
            <source>off</source>
            <translation>off</translation>
        </message>
        <message>
            <source>advising</source>
            <translation>advising</translation>
        </message>
        <message>
            <source>controlling</source>
            <translation>controlling</translation>
        </message>
        <message>
            <source>limited</source>
            <translation>limited</translation>
        </message>
        <message>
            <source>held</source>
            <translation>held</translation>
        </message>
        <message>
            <source>faulted</source>
            <translation>faulted</translation>
        </message>
        <message>
            <source>advise</source>
            <translation>advise</translation>
        </message>
        <message>
            <source>control</source>
            <translation>control</translation>
        </message>
        <message>
            <source>process %1</source>
            <translation>process %1</translation>
        </message>
    </context>
    <context>
    <name>engine</name>
        <message>
            <source>%1 % of the samples are missing: this tap does not count, repeat it.</source>
            <translation>%1 % of the samples are missing: this tap does not count, repeat it.</translation>
        </message>
        <message>
            <source>%1 % of the samples are missing; a record with more than %2 % does not count.</source>
            <translation>%1 % of the samples are missing; a record with more than %2 % does not count.</translation>
        </message>
        <message>
            <source>%1 measurements were accepted, %2 are stored.</source>
            <translation>%1 measurements were accepted, %2 are stored.</translation>
        </message>
        <message>
            <source>%1 must be from %2 to %3.</source>
            <translation>%1 must be from %2 to %3.</translation>
        </message>
        <message>
            <source>A blank profile needs from 1 to %1 steps.</source>
            <translation>A blank profile needs from 1 to %1 steps.</translation>
        </message>
        <message>
            <source>A correction needs a reason.</source>
            <translation>A correction needs a reason.</translation>
        </message>
        <message>
            <source>A deflection must be a number above 0 mm.</source>
            <translation>A deflection must be a number above 0 mm.</translation>
        </message>
        <message>
            <source>A deflection of %1 mm was expected, the entry means %2 mm. Measure again or confirm.</source>
            <translation>A deflection of %1 mm was expected, the entry means %2 mm. Measure again or confirm.</translation>
        </message>
        <message>
            <source>A diameter is a number above zero.</source>
            <translation>A diameter is a number above zero.</translation>
        </message>
        <message>
            <source>A part is being cut.</source>
            <translation>A part is being cut.</translation>
        </message>
        <message>
            <source>A real machine runs at its own speed.</source>
            <translation>A real machine runs at its own speed.</translation>
        </message>
        <message>
            <source>A revolution has %1 samples; expected 2 to %2.</source>
            <translation>A revolution has %1 samples; expected 2 to %2.</translation>
        </message>
        <message>
            <source>A tone is at %1 Hz; expected above 0 and below %2 Hz.</source>
            <translation>A tone is at %1 Hz; expected above 0 and below %2 Hz.</translation>
        </message>
        <message>
            <source>All %1 taps are used.</source>
            <translation>All %1 taps are used.</translation>
        </message>
        <message>
            <source>All loops are held by the operator; the last offset stays.</source>
            <translation>All loops are held by the operator; the last offset stays.</translation>
        </message>
        <message>
            <source>All loops are held: release the hold first.</source>
            <translation>All loops are held: release the hold first.</translation>
        </message>
        <message>
            <source>An infeed of %1 um per revolution leaves no overlap; at this depth at most %2 um.</source>
            <translation>An infeed of %1 um per revolution leaves no overlap; at this depth at most %2 um.</translation>
        </message>
        <message>
            <source>An overhang must be a number above 0 mm.</source>
            <translation>An overhang must be a number above 0 mm.</translation>
        </message>
        <message>
            <source>Another Kerf is already working with this data file.</source>
            <translation>Another Kerf is already working with this data file.</translation>
        </message>
        <message>
            <source>Audit entry %1 was changed after it was written.</source>
            <translation>Audit entry %1 was changed after it was written.</translation>
        </message>
        <message>
            <source>Blank step %1 must end after it begins.</source>
            <translation>Blank step %1 must end after it begins.</translation>
        </message>
        <message>
            <source>Bringing the data file %1 up to date failed at step %2; it is as it was after step %3, and the copy made before is kept.</source>
            <translation>Bringing the data file %1 up to date failed at step %2; it is as it was after step %3, and the copy made before is kept.</translation>
        </message>
        <message>
            <source>Check the spindle encoder. Measure this part at both depths.</source>
            <translation>Check the spindle encoder. Measure this part at both depths.</translation>
        </message>
        <message>
            <source>Check the spindle's position signal. Measure this part at both depths.</source>
            <translation>Check the spindle's position signal. Measure this part at both depths.</translation>
        </message>
        <message>
            <source>Compare the next part with its prediction. Keep the data file for the service.</source>
            <translation>Compare the next part with its prediction. Keep the data file for the service.</translation>
        </message>
        <message>
            <source>Emergency stop</source>
            <translation>Emergency stop</translation>
        </message>
        <message>
            <source>Emergency stop: the control has stopped the machine.</source>
            <translation>Emergency stop: the control has stopped the machine.</translation>
        </message>
        <message>
            <source>End other programs. See Diagnostics for cycle times and how to allow real-time scheduling.</source>
            <translation>End other programs. See Diagnostics for cycle times and how to allow real-time scheduling.</translation>
        </message>
        <message>
            <source>Finished parts are not being stored</source>
            <translation>Finished parts are not being stored</translation>
        </message>
        <message>
            <source>Free disk space or end the program that locks the file. Storing goes on by itself.</source>
            <translation>Free disk space or end the program that locks the file. Storing goes on by itself.</translation>
        </message>
        <message>
            <source>Height of blank step %1 must be from 0 to %2 mm.</source>
            <translation>Height of blank step %1 must be from 0 to %2 mm.</translation>
        </message>
        <message>
            <source>Held again since the release was asked.</source>
            <translation>Held again since the release was asked.</translation>
        </message>
        <message>
            <source>Least error expected at a gain of %1 1/s: %2 mm instead of %3 mm.</source>
            <translation>Least error expected at a gain of %1 1/s: %2 mm instead of %3 mm.</translation>
        </message>
        <message>
            <source>Loops react later than designed. Feed and offsets stay inside their limits.</source>
            <translation>Loops react later than designed. Feed and offsets stay inside their limits.</translation>
        </message>
        <message>
            <source>Matched gain %1 1/s, feed-forward %2 and a learned trim: %3 mm expected.</source>
            <translation>Matched gain %1 1/s, feed-forward %2 and a learned trim: %3 mm expected.</translation>
        </message>
        <message>
            <source>Measurement %1 differs from what was logged when it was accepted.</source>
            <translation>Measurement %1 differs from what was logged when it was accepted.</translation>
        </message>
        <message>
            <source>Measurement %1 is already in the lot.</source>
            <translation>Measurement %1 is already in the lot.</translation>
        </message>
        <message>
            <source>Measurement %1 is not in use any more.</source>
            <translation>Measurement %1 is not in use any more.</translation>
        </message>
        <message>
            <source>No connection to the machine</source>
            <translation>No connection to the machine</translation>
        </message>
        <message>
            <source>No feed schedule is loaded: choose a part type and a lot first.</source>
            <translation>No feed schedule is loaded: choose a part type and a lot first.</translation>
        </message>
        <message>
            <source>No feed schedule is loaded: this bore is cut at its programmed feed.</source>
            <translation>No feed schedule is loaded: this bore is cut at its programmed feed.</translation>
        </message>
        <message>
            <source>No tone is given; expected one frequency in Hz or more.</source>
            <translation>No tone is given; expected one frequency in Hz or more.</translation>
        </message>
        <message>
            <source>Not fitted yet.</source>
            <translation>Not fitted yet.</translation>
        </message>
        <message>
            <source>Part %1 has all of its %2 measurements.</source>
            <translation>Part %1 has all of its %2 measurements.</translation>
        </message>
        <message>
            <source>Part %1 has been measured at %2 mm; correct that value instead.</source>
            <translation>Part %1 has been measured at %2 mm; correct that value instead.</translation>
        </message>
        <message>
            <source>Part %1 has no known feed at %2 mm.</source>
            <translation>Part %1 has no known feed at %2 mm.</translation>
        </message>
        <message>
            <source>Part %1 has not been cut yet.</source>
            <translation>Part %1 has not been cut yet.</translation>
        </message>
        <message>
            <source>Part %1 is already in the lot.</source>
            <translation>Part %1 is already in the lot.</translation>
        </message>
        <message>
            <source>Reading or writing the data file failed: check the disk.</source>
            <translation>Reading or writing the data file failed: check the disk.</translation>
        </message>
        <message>
            <source>Ready: the next bore is cut at its programmed feed.</source>
            <translation>Ready: the next bore is cut at its programmed feed.</translation>
        </message>
        <message>
            <source>Ready: the next bore is cut with the schedule shown.</source>
            <translation>Ready: the next bore is cut with the schedule shown.</translation>
        </message>
        <message>
            <source>Refine the learned trim: %1 mm expected instead of %2 mm.</source>
            <translation>Refine the learned trim: %1 mm expected instead of %2 mm.</translation>
        </message>
        <message>
            <source>Sampling is uneven: %1 ms between samples %2 and the next, %3 ms elsewhere.</source>
            <translation>Sampling is uneven: %1 ms between samples %2 and the next, %3 ms elsewhere.</translation>
        </message>
        <message>
            <source>Schedule %1 of this lot is not stored.</source>
            <translation>Schedule %1 of this lot is not stored.</translation>
        </message>
        <message>
            <source>Set the feed knob to 100 %, or accept the deviation.</source>
            <translation>Set the feed knob to 100 %, or accept the deviation.</translation>
        </message>
        <message>
            <source>Sign on first: a measurement needs a name.</source>
            <translation>Sign on first: a measurement needs a name.</translation>
        </message>
        <message>
            <source>Sign on first: the audit log needs a name.</source>
            <translation>Sign on first: the audit log needs a name.</translation>
        </message>
        <message>
            <source>Simulation speed must be from 1 to 1000, or 0 for as fast as possible.</source>
            <translation>Simulation speed must be from 1 to 1000, or 0 for as fast as possible.</translation>
        </message>
        <message>
            <source>Spindle overhang unknown</source>
            <translation>Spindle overhang unknown</translation>
        </message>
        <message>
            <source>Spindle speed unknown</source>
            <translation>Spindle speed unknown</translation>
        </message>
        <message>
            <source>Sum of errors changed by %1 mm: gain from %2 to %3 1/s.</source>
            <translation>Sum of errors changed by %1 mm: gain from %2 to %3 1/s.</translation>
        </message>
        <message>
            <source>Switched off.</source>
            <translation>Switched off.</translation>
        </message>
        <message>
            <source>The audit log is broken before entry %1: entries are missing.</source>
            <translation>The audit log is broken before entry %1: entries are missing.</translation>
        </message>
        <message>
            <source>The backup %1 could not be written completely.</source>
            <translation>The backup %1 could not be written completely.</translation>
        </message>
        <message>
            <source>The best feed at %1 mm overhang lies outside %2 to %3 mm/rev; it sits at the limit.</source>
            <translation>The best feed at %1 mm overhang lies outside %2 to %3 mm/rev; it sits at the limit.</translation>
        </message>
        <message>
            <source>The best feed lies outside %1 to %2 mm/rev: the feed sits at the limit.</source>
            <translation>The best feed lies outside %1 to %2 mm/rev: the feed sits at the limit.</translation>
        </message>
        <message>
            <source>The best gain no longer moves: %1 1/s.</source>
            <translation>The best gain no longer moves: %1 1/s.</translation>
        </message>
        <message>
            <source>The bore is cut with another feed than planned. The estimate uses the feed really cut.</source>
            <translation>The bore is cut with another feed than planned. The estimate uses the feed really cut.</translation>
        </message>
        <message>
            <source>The boring loop does not know this command.</source>
            <translation>The boring loop does not know this command.</translation>
        </message>
        <message>
            <source>The boring program needs feed, speed and overhangs above zero, the end deeper than the start.</source>
            <translation>The boring program needs feed, speed and overhangs above zero, the end deeper than the start.</translation>
        </message>
        <message>
            <source>The command was not sent: the engine has not taken the earlier ones yet. Try again.</source>
            <translation>The command was not sent: the engine has not taken the earlier ones yet. Try again.</translation>
        </message>
        <message>
            <source>The control is still busy with earlier commands.</source>
            <translation>The control is still busy with earlier commands.</translation>
        </message>
        <message>
            <source>The control no longer answers: cable, network or the control itself.</source>
            <translation>The control no longer answers: cable, network or the control itself.</translation>
        </message>
        <message>
            <source>The control refused the command: is it switched on, homed and idle?</source>
            <translation>The control refused the command: is it switched on, homed and idle?</translation>
        </message>
        <message>
            <source>The control takes no commands: linuxcncrsh does not answer.</source>
            <translation>The control takes no commands: linuxcncrsh does not answer.</translation>
        </message>
        <message>
            <source>The data file %1 cannot be read: check its permissions.</source>
            <translation>The data file %1 cannot be read: check its permissions.</translation>
        </message>
        <message>
            <source>The data file %1 has version %2, written by a newer Kerf; this one knows up to %3. Install the newer program; the file was left as it is.</source>
            <translation>The data file %1 has version %2, written by a newer Kerf; this one knows up to %3. Install the newer program; the file was left as it is.</translation>
        </message>
        <message>
            <source>The data file %1 is damaged; it was left as it is. Go on with the newest backup.</source>
            <translation>The data file %1 is damaged; it was left as it is. Go on with the newest backup.</translation>
        </message>
        <message>
            <source>The data file cannot be opened: check the folder and its permissions.</source>
            <translation>The data file cannot be opened: check the folder and its permissions.</translation>
        </message>
        <message>
            <source>The data file cannot be written: it, or its folder, is read-only.</source>
            <translation>The data file cannot be written: it, or its folder, is read-only.</translation>
        </message>
        <message>
            <source>The data file is damaged: go on with the newest backup and keep this file.</source>
            <translation>The data file is damaged: go on with the newest backup and keep this file.</translation>
        </message>
        <message>
            <source>The data file is in use by another program; try again in a moment.</source>
            <translation>The data file is in use by another program; try again in a moment.</translation>
        </message>
        <message>
            <source>The data file is not a Kerf database.</source>
            <translation>The data file is not a Kerf database.</translation>
        </message>
        <message>
            <source>The data file refused the entry: it contradicts what is already stored.</source>
            <translation>The data file refused the entry: it contradicts what is already stored.</translation>
        </message>
        <message>
            <source>The data file refused the request (code %1).</source>
            <translation>The data file refused the request (code %1).</translation>
        </message>
        <message>
            <source>The data folder cannot be made; choose another one with --data.</source>
            <translation>The data folder cannot be made; choose another one with --data.</translation>
        </message>
        <message>
            <source>The database does not take records: disk full, or the file is locked.</source>
            <translation>The database does not take records: disk full, or the file is locked.</translation>
        </message>
        <message>
            <source>The depth of cut is %1 um; expected above 0, at most the tool radius %2 um.</source>
            <translation>The depth of cut is %1 um; expected above 0, at most the tool radius %2 um.</translation>
        </message>
        <message>
            <source>The disk is full: nothing can be stored until space is made.</source>
            <translation>The disk is full: nothing can be stored until space is made.</translation>
        </message>
        <message>
            <source>The emergency stop of the machine is pressed.</source>
            <translation>The emergency stop of the machine is pressed.</translation>
        </message>
        <message>
            <source>The engine misses its deadlines</source>
            <translation>The engine misses its deadlines</translation>
        </message>
        <message>
            <source>The entry is not a number.</source>
            <translation>The entry is not a number.</translation>
        </message>
        <message>
            <source>The estimate differs from the stored one</source>
            <translation>The estimate differs from the stored one</translation>
        </message>
        <message>
            <source>The estimated exponent α = %1 is outside %2 to %3 and was clipped.</source>
            <translation>The estimated exponent α = %1 is outside %2 to %3 and was clipped.</translation>
        </message>
        <message>
            <source>The extra delay is %1 samples; expected 0 or 1.</source>
            <translation>The extra delay is %1 samples; expected 0 or 1.</translation>
        </message>
        <message>
            <source>The feed does not follow the schedule</source>
            <translation>The feed does not follow the schedule</translation>
        </message>
        <message>
            <source>The feed follows the schedule along the bore.</source>
            <translation>The feed follows the schedule along the bore.</translation>
        </message>
        <message>
            <source>The feed schedule has a value outside its range; the last one stays.</source>
            <translation>The feed schedule has a value outside its range; the last one stays.</translation>
        </message>
        <message>
            <source>The file %1 exists already; a backup never overwrites.</source>
            <translation>The file %1 exists already; a backup never overwrites.</translation>
        </message>
        <message>
            <source>The file %1 is a database of another program; it was left as it is.</source>
            <translation>The file %1 is a database of another program; it was left as it is.</translation>
        </message>
        <message>
            <source>The file %1 is not a database; it was left as it is.</source>
            <translation>The file %1 is not a database; it was left as it is.</translation>
        </message>
        <message>
            <source>The finished part is kept in memory. No new part can be started.</source>
            <translation>The finished part is kept in memory. No new part can be started.</translation>
        </message>
        <message>
            <source>The forgetting factor is %1; expected 0.5 to 1.</source>
            <translation>The forgetting factor is %1; expected 0.5 to 1.</translation>
        </message>
        <message>
            <source>The gain error is %1; expected above 0, at most 10.</source>
            <translation>The gain error is %1; expected above 0, at most 10.</translation>
        </message>
        <message>
            <source>The infeed is %1 um per revolution; expected 0 or more.</source>
            <translation>The infeed is %1 um per revolution; expected 0 or more.</translation>
        </message>
        <message>
            <source>The initial covariance is %1; expected above 0, at most 1e9.</source>
            <translation>The initial covariance is %1; expected above 0, at most 1e9.</translation>
        </message>
        <message>
            <source>The last part is not stored yet: no new part until it is.</source>
            <translation>The last part is not stored yet: no new part until it is.</translation>
        </message>
        <message>
            <source>The length of a blank segment must be above 0 and at most %1 mm.</source>
            <translation>The length of a blank segment must be above 0 and at most %1 mm.</translation>
        </message>
        <message>
            <source>The limit of the forgetting is %1; expected 0 or more.</source>
            <translation>The limit of the forgetting is %1; expected 0 or more.</translation>
        </message>
        <message>
            <source>The lot was computed again from its stored measurements and gave another state than the one stored with the last of them: another version of the program, or a changed file.</source>
            <translation>The lot was computed again from its stored measurements and gave another state than the one stored with the last of them: another version of the program, or a changed file.</translation>
        </message>
        <message>
            <source>The machine is not ready.</source>
            <translation>The machine is not ready.</translation>
        </message>
        <message>
            <source>The machine is switched off.</source>
            <translation>The machine is switched off.</translation>
        </message>
        <message>
            <source>The measurement to be replaced is not stored.</source>
            <translation>The measurement to be replaced is not stored.</translation>
        </message>
        <message>
            <source>The newly computed estimate and feed schedule are used.</source>
            <translation>The newly computed estimate and feed schedule are used.</translation>
        </message>
        <message>
            <source>The operator's feed knob, a limit of the control, or its acceleration keeps the feed away from the schedule.</source>
            <translation>The operator's feed knob, a limit of the control, or its acceleration keeps the feed away from the schedule.</translation>
        </message>
        <message>
            <source>The part belongs to no lot: no estimator can learn from it.</source>
            <translation>The part belongs to no lot: no estimator can learn from it.</translation>
        </message>
        <message>
            <source>The part of this measurement is not stored.</source>
            <translation>The part of this measurement is not stored.</translation>
        </message>
        <message>
            <source>The recipe has no revision %1.</source>
            <translation>The recipe has no revision %1.</translation>
        </message>
        <message>
            <source>The record has %1 samples; at least %2 are needed.</source>
            <translation>The record has %1 samples; at least %2 are needed.</translation>
        </message>
        <message>
            <source>The schedule wants %1 of the programmed feed; this control allows %2.</source>
            <translation>The schedule wants %1 of the programmed feed; this control allows %2.</translation>
        </message>
        <message>
            <source>The spindle cannot bend by %1 mm; its deflection must be above 0. Measure again.</source>
            <translation>The spindle cannot bend by %1 mm; its deflection must be above 0. Measure again.</translation>
        </message>
        <message>
            <source>The spindle position jumps by no whole number of revolutions: counts are lost or the column is not in revolutions.</source>
            <translation>The spindle position jumps by no whole number of revolutions: counts are lost or the column is not in revolutions.</translation>
        </message>
        <message>
            <source>The spindle speed is %1 rev/s; expected %2 to %3.</source>
            <translation>The spindle speed is %1 rev/s; expected %2 to %3.</translation>
        </message>
        <message>
            <source>The spindle turns %1 rev in the whole record; a tap needs at least one.</source>
            <translation>The spindle turns %1 rev in the whole record; a tap needs at least one.</translation>
        </message>
        <message>
            <source>The spindle turns up to %1 rev between two samples; at most %2 rev: sample faster.</source>
            <translation>The spindle turns up to %1 rev between two samples; at most %2 rev: sample faster.</translation>
        </message>
        <message>
            <source>The spindle's speed signal is missing, old or not a number.</source>
            <translation>The spindle's speed signal is missing, old or not a number.</translation>
        </message>
        <message>
            <source>The tool radius is %1 um; expected above 0, at most 1000000 um.</source>
            <translation>The tool radius is %1 um; expected above 0, at most 1000000 um.</translation>
        </message>
        <message>
            <source>There is no such alarm.</source>
            <translation>There is no such alarm.</translation>
        </message>
        <message>
            <source>There is no such part.</source>
            <translation>There is no such part.</translation>
        </message>
        <message>
            <source>This LinuxCNC brings no such signal over HAL.</source>
            <translation>This LinuxCNC brings no such signal over HAL.</translation>
        </message>
        <message>
            <source>This LinuxCNC has no external offsets: set OFFSET_AV_RATIO in its ini.</source>
            <translation>This LinuxCNC has no external offsets: set OFFSET_AV_RATIO in its ini.</translation>
        </message>
        <message>
            <source>This computer is too busy, or real-time scheduling is not allowed.</source>
            <translation>This computer is too busy, or real-time scheduling is not allowed.</translation>
        </message>
        <message>
            <source>This control cannot do that.</source>
            <translation>This control cannot do that.</translation>
        </message>
        <message>
            <source>This control has no program for that process.</source>
            <translation>This control has no program for that process.</translation>
        </message>
        <message>
            <source>This lot is closed already, or there is none of that number.</source>
            <translation>This lot is closed already, or there is none of that number.</translation>
        </message>
        <message>
            <source>This machine cannot host this loop.</source>
            <translation>This machine cannot host this loop.</translation>
        </message>
        <message>
            <source>This measurement was replaced meanwhile: look at the newest value first.</source>
            <translation>This measurement was replaced meanwhile: look at the newest value first.</translation>
        </message>
        <message>
            <source>This simulated machine does not have it.</source>
            <translation>This simulated machine does not have it.</translation>
        </message>
        <message>
            <source>Time does not rise at sample %1; expected one row per sample, oldest first.</source>
            <translation>Time does not rise at sample %1; expected one row per sample, oldest first.</translation>
        </message>
        <message>
            <source>Too many entries are waiting to be stored; try again in a moment.</source>
            <translation>Too many entries are waiting to be stored; try again in a moment.</translation>
        </message>
        <message>
            <source>What is left (%1 mm) is noise and scatter: further taps would not help.</source>
            <translation>What is left (%1 mm) is noise and scatter: further taps would not help.</translation>
        </message>
        <message>
            <source>Worse than before (%1 mm against %2 mm): back half way.</source>
            <translation>Worse than before (%1 mm against %2 mm): back half way.</translation>
        </message>
        <message>
            <source>Z moves %1 mm per revolution; that does not fit a pitch of %2 mm.</source>
            <translation>Z moves %1 mm per revolution; that does not fit a pitch of %2 mm.</translation>
        </message>
        <message>
            <source>%1 mm is far from the %2 mm expected here. Measure again, or confirm that it is so.</source>
            <translation>%1 mm is far from the %2 mm expected here. Measure again, or confirm that it is so.</translation>
        </message>
        <message>
            <source>A bore is measured at 1 to %1 depths.</source>
            <translation>A bore is measured at 1 to %1 depths.</translation>
        </message>
        <message>
            <source>A bore of %1 mm cannot be: without any bending it would be %2 mm. Measure again.</source>
            <translation>A bore of %1 mm cannot be: without any bending it would be %2 mm. Measure again.</translation>
        </message>
        <message>
            <source>A bore of part %1 was corrected; everything after it was computed again.</source>
            <translation>A bore of part %1 was corrected; everything after it was computed again.</translation>
        </message>
        <message>
            <source>A bore of part %1 was taken out; everything after it was computed again.</source>
            <translation>A bore of part %1 was taken out; everything after it was computed again.</translation>
        </message>
        <message>
            <source>A value is being stored; try again in a moment.</source>
            <translation>A value is being stored; try again in a moment.</translation>
        </message>
        <message>
            <source>Angle of the deflection</source>
            <translation>Angle of the deflection</translation>
        </message>
        <message>
            <source>Depths must differ and lie inside the bore; %1 mm does not.</source>
            <translation>Depths must differ and lie inside the bore; %1 mm does not.</translation>
        </message>
        <message>
            <source>Feed exponent by experience</source>
            <translation>Feed exponent by experience</translation>
        </message>
        <message>
            <source>Feed of the first part</source>
            <translation>Feed of the first part</translation>
        </message>
        <message>
            <source>Highest feed</source>
            <translation>Highest feed</translation>
        </message>
        <message>
            <source>Largest diameter</source>
            <translation>Largest diameter</translation>
        </message>
        <message>
            <source>Lot %1 was computed again from its measurements and differs from the stored state.</source>
            <translation>Lot %1 was computed again from its measurements and differs from the stored state.</translation>
        </message>
        <message>
            <source>Lowest feed</source>
            <translation>Lowest feed</translation>
        </message>
        <message>
            <source>Nothing is measured yet: the part is cut at the constant feed of %1 mm/rev.</source>
            <translation>Nothing is measured yet: the part is cut at the constant feed of %1 mm/rev.</translation>
        </message>
        <message>
            <source>Overhang at the bottom</source>
            <translation>Overhang at the bottom</translation>
        </message>
        <message>
            <source>Overhang at the top</source>
            <translation>Overhang at the top</translation>
        </message>
        <message>
            <source>Part %1 came out %2 µm larger than its target on average.</source>
            <translation>Part %1 came out %2 µm larger than its target on average.</translation>
        </message>
        <message>
            <source>Part %1 came out %2 µm smaller than its target on average.</source>
            <translation>Part %1 came out %2 µm smaller than its target on average.</translation>
        </message>
        <message>
            <source>Part %1 came out on its target.</source>
            <translation>Part %1 came out on its target.</translation>
        </message>
        <message>
            <source>Smallest diameter</source>
            <translation>Smallest diameter</translation>
        </message>
        <message>
            <source>Spindle speed</source>
            <translation>Spindle speed</translation>
        </message>
        <message>
            <source>Standard deviation of the gauge</source>
            <translation>Standard deviation of the gauge</translation>
        </message>
        <message>
            <source>Target deflection</source>
            <translation>Target deflection</translation>
        </message>
        <message>
            <source>Target diameter</source>
            <translation>Target diameter</translation>
        </message>
        <message>
            <source>The bores differ from their prediction by more than chance: T² %1, limit %2.</source>
            <translation>The bores differ from their prediction by more than chance: T² %1, limit %2.</translation>
        </message>
        <message>
            <source>The lot asks for an estimator that this program does not have.</source>
            <translation>The lot asks for an estimator that this program does not have.</translation>
        </message>
        <message>
            <source>The lowest feed must be below the highest one.</source>
            <translation>The lowest feed must be below the highest one.</translation>
        </message>
        <message>
            <source>The overhang at the top must be below the one at the bottom.</source>
            <translation>The overhang at the top must be below the one at the bottom.</translation>
        </message>
        <message>
            <source>The part type has no such depth.</source>
            <translation>The part type has no such depth.</translation>
        </message>
        <message>
            <source>The part type's parameters cannot be read; they need numbers under their keys.</source>
            <translation>The part type's parameters cannot be read; they need numbers under their keys.</translation>
        </message>
        <message>
            <source>The process changed with part %1: the law is learned anew from there.</source>
            <translation>The process changed with part %1: the law is learned anew from there.</translation>
        </message>
        <message>
            <source>The target diameter must lie between the smallest and the largest one.</source>
            <translation>The target diameter must lie between the smallest and the largest one.</translation>
        </message>
        <message>
            <source>There is no measurement to undo.</source>
            <translation>There is no measurement to undo.</translation>
        </message>
        <message>
            <source>There is no such lot.</source>
            <translation>There is no such lot.</translation>
        </message>
        <message>
            <source>This bore has a value already; correct that one instead.</source>
            <translation>This bore has a value already; correct that one instead.</translation>
        </message>
        <message>
            <source>This part has no finished bore to measure.</source>
            <translation>This part has no finished bore to measure.</translation>
        </message>
        <message>
            <source>This value was replaced or taken out meanwhile; look at the newest one first.</source>
            <translation>This value was replaced or taken out meanwhile; look at the newest one first.</translation>
        </message>
        <message>
            <source>Three measurements in a row lie more than 3σ off the target deflection.</source>
            <translation>Three measurements in a row lie more than 3σ off the target deflection.</translation>
        </message>
        <message>
            <source>drawing of the part</source>
            <translation>drawing of the part</translation>
        </message>
        <message>
            <source>set up with the machine</source>
            <translation>set up with the machine</translation>
        </message>
        <message>
            <source>table 1 of Lee (1983)</source>
            <translation>table 1 of Lee (1983)</translation>
        </message>
        <message>
            <source>%1 has other temperature columns than %2; train with days of one machine.</source>
            <translation>%1 has other temperature columns than %2; train with days of one machine.</translation>
        </message>
        <message>
            <source>%1 is out of range; expected %2 to %3 degC.</source>
            <translation>%1 is out of range; expected %2 to %3 degC.</translation>
        </message>
        <message>
            <source>%1 min does not follow %2 min; expected rising time.</source>
            <translation>%1 min does not follow %2 min; expected rising time.</translation>
        </message>
        <message>
            <source>A network of pairs needs at least 2 inputs; got %1.</source>
            <translation>A network of pairs needs at least 2 inputs; got %1.</translation>
        </message>
        <message>
            <source>A training or check set has only %1 rows; expected at least %2.</source>
            <translation>A training or check set has only %1 rows; expected at least %2.</translation>
        </message>
        <message>
            <source>Network width %1 is out of range; expected 1 to %2.</source>
            <translation>Network width %1 is out of range; expected 1 to %2.</translation>
        </message>
        <message>
            <source>No training day was given.</source>
            <translation>No training day was given.</translation>
        </message>
        <message>
            <source>The network reads %1 sensors; at most %2 are supported.</source>
            <translation>The network reads %1 sensors; at most %2 are supported.</translation>
        </message>
        <message>
            <source>Training was cancelled.</source>
            <translation>Training was cancelled.</translation>
        </message>
        <message>
            <source>baseline of %1 looks like degrees Fahrenheit; expected degC.</source>
            <translation>baseline of %1 looks like degrees Fahrenheit; expected degC.</translation>
        </message>
        <message>
            <source>constant at %1 in every row; expected a temperature that moves. Leave the column out.</source>
            <translation>constant at %1 in every row; expected a temperature that moves. Leave the column out.</translation>
        </message>
        <message>
            <source>fewer than two temperature columns.</source>
            <translation>fewer than two temperature columns.</translation>
        </message>
        <message>
            <source>gap of %1 min; expected an even step of %2 min without gaps.</source>
            <translation>gap of %1 min; expected an even step of %2 min without gaps.</translation>
        </message>
        <message>
            <source>largest drift is %1 while the machine warms by %2 K; expected um, not mm.</source>
            <translation>largest drift is %1 while the machine warms by %2 K; expected um, not mm.</translation>
        </message>
        <message>
            <source>no reading; training data must be without gaps.</source>
            <translation>no reading; training data must be without gaps.</translation>
        </message>
        <message>
            <source>no row at or after time 0.</source>
            <translation>no row at or after time 0.</translation>
        </message>
        <message>
            <source>no row before time 0; expected at least one baseline row with t_min &lt; 0.</source>
            <translation>no row before time 0; expected at least one baseline row with t_min &lt; 0.</translation>
        </message>
        <message>
            <source>no usable drift; expected a number from -1000 to 1000 um.</source>
            <translation>no usable drift; expected a number from -1000 to 1000 um.</translation>
        </message>
        <message>
            <source>only %1 rows from time 0; training needs at least %2.</source>
            <translation>only %1 rows from time 0; training needs at least %2.</translation>
        </message>
        <message>
            <source>too short; expected baseline rows and at least one row from time 0.</source>
            <translation>too short; expected baseline rows and at least one row from time 0.</translation>
        </message>
        <message>
            <source>%1 times the force at the start of the cut.</source>
            <translation>%1 times the force at the start of the cut.</translation>
        </message>
        <message>
            <source>A vibration repeats with every revolution, so the force does not change with it.</source>
            <translation>A vibration repeats with every revolution, so the force does not change with it.</translation>
        </message>
        <message>
            <source>At most 8 known tones.</source>
            <translation>At most 8 known tones.</translation>
        </message>
        <message>
            <source>Check depth of cut and amplifier range before the next part.</source>
            <translation>Check depth of cut and amplifier range before the next part.</translation>
        </message>
        <message>
            <source>Check depth of cut and touch-off before the next part.</source>
            <translation>Check depth of cut and touch-off before the next part.</translation>
        </message>
        <message>
            <source>Choose the spindle speed that the page suggests.</source>
            <translation>Choose the spindle speed that the page suggests.</translation>
        </message>
        <message>
            <source>Find the source of the vibration; see the spectrum's tones.</source>
            <translation>Find the source of the vibration; see the spectrum's tones.</translation>
        </message>
        <message>
            <source>Force feedback needs a cycle of 0.2 ms; this machine has %1 ms: no trim.</source>
            <translation>Force feedback needs a cycle of 0.2 ms; this machine has %1 ms: no trim.</translation>
        </message>
        <message>
            <source>Force sensor at the end of its range</source>
            <translation>Force sensor at the end of its range</translation>
        </message>
        <message>
            <source>Force sensor at the end of its range: no trim in this part.</source>
            <translation>Force sensor at the end of its range: no trim in this part.</translation>
        </message>
        <message>
            <source>Force signal lost</source>
            <translation>Force signal lost</translation>
        </message>
        <message>
            <source>Force signal lost: the trim is zero.</source>
            <translation>Force signal lost: the trim is zero.</translation>
        </message>
        <message>
            <source>Listening to the disturbance: no trim yet.</source>
            <translation>Listening to the disturbance: no trim yet.</translation>
        </message>
        <message>
            <source>No turning setup is loaded: enter the cut first.</source>
            <translation>No turning setup is loaded: enter the cut first.</translation>
        </message>
        <message>
            <source>None, unless it comes back with every part: then check the sensor's insulation.</source>
            <translation>None, unless it comes back with every part: then check the sensor's insulation.</translation>
        </message>
        <message>
            <source>Out of the cut: the sensor's zero is taken.</source>
            <translation>Out of the cut: the sensor's zero is taken.</translation>
        </message>
        <message>
            <source>Part of the disturbance stays on the surface.</source>
            <translation>Part of the disturbance stays on the surface.</translation>
        </message>
        <message>
            <source>Ready: force feedback begins at the touch of the next part.</source>
            <translation>Ready: force feedback begins at the touch of the next part.</translation>
        </message>
        <message>
            <source>The cut is deeper or the amplifier more sensitive than the sensor's range allows.</source>
            <translation>The cut is deeper or the amplifier more sensitive than the sensor's range allows.</translation>
        </message>
        <message>
            <source>The cutting force has jumped: the tool may be chipped</source>
            <translation>The cutting force has jumped: the tool may be chipped</translation>
        </message>
        <message>
            <source>The cutting force has jumped: the trim is zero, look at the tool.</source>
            <translation>The cutting force has jumped: the trim is zero, look at the tool.</translation>
        </message>
        <message>
            <source>The disturbance is larger than the trim may correct.</source>
            <translation>The disturbance is larger than the trim may correct.</translation>
        </message>
        <message>
            <source>The face must end beyond its start.</source>
            <translation>The face must end beyond its start.</translation>
        </message>
        <message>
            <source>The force cannot see a tone at this spindle speed</source>
            <translation>The force cannot see a tone at this spindle speed</translation>
        </message>
        <message>
            <source>The force sensor has drifted</source>
            <translation>The force sensor has drifted</translation>
        </message>
        <message>
            <source>The force sensor is unplugged, its values are old, not numbers, or do not change any more.</source>
            <translation>The force sensor is unplugged, its values are old, not numbers, or do not change any more.</translation>
        </message>
        <message>
            <source>The mean of the trim is not zero: the loop would change the depth of cut.</source>
            <translation>The mean of the trim is not zero: the loop would change the depth of cut.</translation>
        </message>
        <message>
            <source>The piezo sensor's zero out of the cut is not where it was.</source>
            <translation>The piezo sensor's zero out of the cut is not where it was.</translation>
        </message>
        <message>
            <source>The same depth takes clearly more force than at the start of this cut.</source>
            <translation>The same depth takes clearly more force than at the start of this cut.</translation>
        </message>
        <message>
            <source>The tone is held only for about a minute; then it comes back on the surface.</source>
            <translation>The tone is held only for about a minute; then it comes back on the surface.</translation>
        </message>
        <message>
            <source>The tool has touched: first revolution.</source>
            <translation>The tool has touched: first revolution.</translation>
        </message>
        <message>
            <source>The trim cancels %1 tones of the disturbance.</source>
            <translation>The trim cancels %1 tones of the disturbance.</translation>
        </message>
        <message>
            <source>The trim has gone to zero for the rest of this part.</source>
            <translation>The trim has gone to zero for the rest of this part.</translation>
        </message>
        <message>
            <source>The trim has gone to zero for the rest of this part; the depth is the programmed one.</source>
            <translation>The trim has gone to zero for the rest of this part; the depth is the programmed one.</translation>
        </message>
        <message>
            <source>The trim leans to one side</source>
            <translation>The trim leans to one side</translation>
        </message>
        <message>
            <source>The trim leans to one side: no trim in this part.</source>
            <translation>The trim leans to one side: no trim in this part.</translation>
        </message>
        <message>
            <source>The trim sits at its limit</source>
            <translation>The trim sits at its limit</translation>
        </message>
        <message>
            <source>The turning loop does not know this command.</source>
            <translation>The turning loop does not know this command.</translation>
        </message>
        <message>
            <source>The turning program needs feed and depth above zero, 150 to 30000 rev/min, and an end beyond its start.</source>
            <translation>The turning program needs feed and depth above zero, 150 to 30000 rev/min, and an end beyond its start.</translation>
        </message>
        <message>
            <source>The zero has moved by %1 N.</source>
            <translation>The zero has moved by %1 N.</translation>
        </message>
        <message>
            <source>The zero was taken again; the force shown is right.</source>
            <translation>The zero was taken again; the force shown is right.</translation>
        </message>
        <message>
            <source>%1 N at %2 mm; the limit is %3 N.</source>
            <translation>%1 N at %2 mm; the limit is %3 N.</translation>
        </message>
        <message>
            <source>%1 revolutions in, at %2 mm.</source>
            <translation>%1 revolutions in, at %2 mm.</translation>
        </message>
        <message>
            <source>%1 µm at %2 revolutions; the limit is %3 µm.</source>
            <translation>%1 µm at %2 revolutions; the limit is %3 µm.</translation>
        </message>
        <message>
            <source>A gain is not a number above zero; the last ones stay.</source>
            <translation>A gain is not a number above zero; the last ones stay.</translation>
        </message>
        <message>
            <source>A part is being cut: law and reference can be changed now, the rest after it.</source>
            <translation>A part is being cut: law and reference can be changed now, the rest after it.</translation>
        </message>
        <message>
            <source>A tap is under way.</source>
            <translation>A tap is under way.</translation>
        </message>
        <message>
            <source>A tap is under way: the job stays.</source>
            <translation>A tap is under way: the job stays.</translation>
        </message>
        <message>
            <source>A tap stands in the hole: turn it out first.</source>
            <translation>A tap stands in the hole: turn it out first.</translation>
        </message>
        <message>
            <source>A tuning is under way: accept it or roll it back first.</source>
            <translation>A tuning is under way: accept it or roll it back first.</translation>
        </message>
        <message>
            <source>Across-wall stiffness</source>
            <translation>Across-wall stiffness</translation>
        </message>
        <message>
            <source>Air tap: Z and spindle move, no work.</source>
            <translation>Air tap: Z and spindle move, no work.</translation>
        </message>
        <message>
            <source>An emergency stop or an abort at the control stopped the tap before it was out.</source>
            <translation>An emergency stop or an abort at the control stopped the tap before it was out.</translation>
        </message>
        <message>
            <source>Change the reference or the feed limits, or accept the deviation.</source>
            <translation>Change the reference or the feed limits, or accept the deviation.</translation>
        </message>
        <message>
            <source>Change the tool and press New tool on the Milling page.</source>
            <translation>Change the tool and press New tool on the Milling page.</translation>
        </message>
        <message>
            <source>Check tap and lubrication, then tune again.</source>
            <translation>Check tap and lubrication, then tune again.</translation>
        </message>
        <message>
            <source>Check that the control allows setting gains, then try again.</source>
            <translation>Check that the control allows setting gains, then try again.</translation>
        </message>
        <message>
            <source>Check the axis' position signal. Control goes on by itself when it is back.</source>
            <translation>Check the axis' position signal. Control goes on by itself when it is back.</translation>
        </message>
        <message>
            <source>Check the encoders. Gauge the thread.</source>
            <translation>Check the encoders. Gauge the thread.</translation>
        </message>
        <message>
            <source>Check the force sensor, its plug and its amplifier. Control goes on by itself when the signal is back.</source>
            <translation>Check the force sensor, its plug and its amplifier. Control goes on by itself when the signal is back.</translation>
        </message>
        <message>
            <source>Compare pitch entered, program and tool before the next tap.</source>
            <translation>Compare pitch entered, program and tool before the next tap.</translation>
        </message>
        <message>
            <source>Control would have held the feed: see the alarm.</source>
            <translation>Control would have held the feed: see the alarm.</translation>
        </message>
        <message>
            <source>Cutting force above its limit</source>
            <translation>Cutting force above its limit</translation>
        </message>
        <message>
            <source>Cutting force unknown</source>
            <translation>Cutting force unknown</translation>
        </message>
        <message>
            <source>Cutting force unknown: no faster than planned.</source>
            <translation>Cutting force unknown: no faster than planned.</translation>
        </message>
        <message>
            <source>Entry feed</source>
            <translation>Entry feed</translation>
        </message>
        <message>
            <source>Feed really made is unknown</source>
            <translation>Feed really made is unknown</translation>
        </message>
        <message>
            <source>Feed really made is unknown: no faster than planned.</source>
            <translation>Feed really made is unknown: no faster than planned.</translation>
        </message>
        <message>
            <source>Flutes</source>
            <translation>Flutes</translation>
        </message>
        <message>
            <source>Force angle</source>
            <translation>Force angle</translation>
        </message>
        <message>
            <source>Force limit</source>
            <translation>Force limit</translation>
        </message>
        <message>
            <source>Gains are being set; nothing turns.</source>
            <translation>Gains are being set; nothing turns.</translation>
        </message>
        <message>
            <source>Gains change only between taps.</source>
            <translation>Gains change only between taps.</translation>
        </message>
        <message>
            <source>Gauge the thread. Look at the record before the next trial.</source>
            <translation>Gauge the thread. Look at the record before the next trial.</translation>
        </message>
        <message>
            <source>In air: entry feed until the tool meets the work.</source>
            <translation>In air: entry feed until the tool meets the work.</translation>
        </message>
        <message>
            <source>Integral gain</source>
            <translation>Integral gain</translation>
        </message>
        <message>
            <source>Material exponent</source>
            <translation>Material exponent</translation>
        </message>
        <message>
            <source>No blank profile is loaded: enter or import one.</source>
            <translation>No blank profile is loaded: enter or import one.</translation>
        </message>
        <message>
            <source>No cut to learn from yet: mill one part, advising or controlled.</source>
            <translation>No cut to learn from yet: mill one part, advising or controlled.</translation>
        </message>
        <message>
            <source>No milling setup is loaded.</source>
            <translation>No milling setup is loaded.</translation>
        </message>
        <message>
            <source>No tap is made.</source>
            <translation>No tap is made.</translation>
        </message>
        <message>
            <source>No tap stands in a hole.</source>
            <translation>No tap stands in a hole.</translation>
        </message>
        <message>
            <source>No tapping job is loaded.</source>
            <translation>No tapping job is loaded.</translation>
        </message>
        <message>
            <source>Path end</source>
            <translation>Path end</translation>
        </message>
        <message>
            <source>Path start</source>
            <translation>Path start</translation>
        </message>
        <message>
            <source>Planned feed</source>
            <translation>Planned feed</translation>
        </message>
        <message>
            <source>Proportional gain</source>
            <translation>Proportional gain</translation>
        </message>
        <message>
            <source>Ready: the first tap of the job is an air tap.</source>
            <translation>Ready: the first tap of the job is an air tap.</translation>
        </message>
        <message>
            <source>Ready: the next cut holds the reference force.</source>
            <translation>Ready: the next cut holds the reference force.</translation>
        </message>
        <message>
            <source>Ready: the next cut is made at its planned feed.</source>
            <translation>Ready: the next cut is made at its planned feed.</translation>
        </message>
        <message>
            <source>Ready: the next tap uses the gains shown.</source>
            <translation>Ready: the next tap uses the gains shown.</translation>
        </message>
        <message>
            <source>Ready: the next tap uses the machine's own gains.</source>
            <translation>Ready: the next tap uses the machine's own gains.</translation>
        </message>
        <message>
            <source>Reference force</source>
            <translation>Reference force</translation>
        </message>
        <message>
            <source>Reference force out of reach</source>
            <translation>Reference force out of reach</translation>
        </message>
        <message>
            <source>Repeat the tap.</source>
            <translation>Repeat the tap.</translation>
        </message>
        <message>
            <source>Spindle angle or Z position were missing for more than 20 ms during a tap.</source>
            <translation>Spindle angle or Z position were missing for more than 20 ms during a tap.</translation>
        </message>
        <message>
            <source>Spindle stopped in the cut</source>
            <translation>Spindle stopped in the cut</translation>
        </message>
        <message>
            <source>Switch the tapping loop to control to turn the tap out.</source>
            <translation>Switch the tapping loop to control to turn the tap out.</translation>
        </message>
        <message>
            <source>Tap not counted</source>
            <translation>Tap not counted</translation>
        </message>
        <message>
            <source>Tapping and recording.</source>
            <translation>Tapping and recording.</translation>
        </message>
        <message>
            <source>Tapping error beyond its limit</source>
            <translation>Tapping error beyond its limit</translation>
        </message>
        <message>
            <source>Tapping error has grown</source>
            <translation>Tapping error has grown</translation>
        </message>
        <message>
            <source>Tapping signal lost</source>
            <translation>Tapping signal lost</translation>
        </message>
        <message>
            <source>The air tap shows another pitch than the one entered.</source>
            <translation>The air tap shows another pitch than the one entered.</translation>
        </message>
        <message>
            <source>The cutting force collapsed within half a revolution while the tool was in the work.</source>
            <translation>The cutting force collapsed within half a revolution while the tool was in the work.</translation>
        </message>
        <message>
            <source>The cutting stiffness has risen by %1 % since the tool was new.</source>
            <translation>The cutting stiffness has risen by %1 % since the tool was new.</translation>
        </message>
        <message>
            <source>The database cannot be opened for the export.</source>
            <translation>The database cannot be opened for the export.</translation>
        </message>
        <message>
            <source>The depth of cut is larger than expected, the tool is blunt, or the material is harder.</source>
            <translation>The depth of cut is larger than expected, the tool is blunt, or the material is harder.</translation>
        </message>
        <message>
            <source>The drive did not take the gains</source>
            <translation>The drive did not take the gains</translation>
        </message>
        <message>
            <source>The engine takes no commands at the moment; try again.</source>
            <translation>The engine takes no commands at the moment; try again.</translation>
        </message>
        <message>
            <source>The export could not be written completely.</source>
            <translation>The export could not be written completely.</translation>
        </message>
        <message>
            <source>The feed holds the reference force.</source>
            <translation>The feed holds the reference force.</translation>
        </message>
        <message>
            <source>The feed is held: see the alarm, then release the feed here.</source>
            <translation>The feed is held: see the alarm, then release the feed here.</translation>
        </message>
        <message>
            <source>The feed is not controlled: it stays, or falls to the planned feed if it was faster.</source>
            <translation>The feed is not controlled: it stays, or falls to the planned feed if it was faster.</translation>
        </message>
        <message>
            <source>The feed signal of the axis is missing, old or not a number.</source>
            <translation>The feed signal of the axis is missing, old or not a number.</translation>
        </message>
        <message>
            <source>The feed sits at its limit: the blank is too thin or too thick for the reference.</source>
            <translation>The feed sits at its limit: the blank is too thin or too thick for the reference.</translation>
        </message>
        <message>
            <source>The feed stands; control goes on with it.</source>
            <translation>The feed stands; control goes on with it.</translation>
        </message>
        <message>
            <source>The file cannot be written there. Choose another folder.</source>
            <translation>The file cannot be written there. Choose another folder.</translation>
        </message>
        <message>
            <source>The file could not be finished: the disk is full or was taken away.</source>
            <translation>The file could not be finished: the disk is full or was taken away.</translation>
        </message>
        <message>
            <source>The force differs from the reference, so the wall is not as flat as it could be.</source>
            <translation>The force differs from the reference, so the wall is not as flat as it could be.</translation>
        </message>
        <message>
            <source>The force sensor is not plugged in.</source>
            <translation>The force sensor is not plugged in.</translation>
        </message>
        <message>
            <source>The force signal is at the end of its range.</source>
            <translation>The force signal is at the end of its range.</translation>
        </message>
        <message>
            <source>The force signal is missing, old, stuck, at the end of its range or not a number.</source>
            <translation>The force signal is missing, old, stuck, at the end of its range or not a number.</translation>
        </message>
        <message>
            <source>The force signal is old.</source>
            <translation>The force signal is old.</translation>
        </message>
        <message>
            <source>The force signal is stuck or not a number.</source>
            <translation>The force signal is stuck or not a number.</translation>
        </message>
        <message>
            <source>The gains sent to the drive were refused or did not read back within a second.</source>
            <translation>The gains sent to the drive were refused or did not read back within a second.</translation>
        </message>
        <message>
            <source>The milling loop does not know this command.</source>
            <translation>The milling loop does not know this command.</translation>
        </message>
        <message>
            <source>The milling program needs feed and speed above zero and an end beyond its start.</source>
            <translation>The milling program needs feed and speed above zero and an end beyond its start.</translation>
        </message>
        <message>
            <source>The milling setup is not complete.</source>
            <translation>The milling setup is not complete.</translation>
        </message>
        <message>
            <source>The planned feed is kept.</source>
            <translation>The planned feed is kept.</translation>
        </message>
        <message>
            <source>The reference force needs a feed outside %1 to %2 mm/s.</source>
            <translation>The reference force needs a feed outside %1 to %2 mm/s.</translation>
        </message>
        <message>
            <source>The same cut needs a larger force than with the new tool.</source>
            <translation>The same cut needs a larger force than with the new tool.</translation>
        </message>
        <message>
            <source>The spindle turns slower than half its programmed speed, or its speed is unknown.</source>
            <translation>The spindle turns slower than half its programmed speed, or its speed is unknown.</translation>
        </message>
        <message>
            <source>The sum of errors of the last taps lies above that of the first taps after the tuning.</source>
            <translation>The sum of errors of the last taps lies above that of the first taps after the tuning.</translation>
        </message>
        <message>
            <source>The tap is turned out in sync.</source>
            <translation>The tap is turned out in sync.</translation>
        </message>
        <message>
            <source>The tap stands %1 revolutions in the hole: turn it out in sync.</source>
            <translation>The tap stands %1 revolutions in the hole: turn it out in sync.</translation>
        </message>
        <message>
            <source>The tap stands in the hole</source>
            <translation>The tap stands in the hole</translation>
        </message>
        <message>
            <source>The tap stands in the hole.</source>
            <translation>The tap stands in the hole.</translation>
        </message>
        <message>
            <source>The tap stands in the hole: turn it out in sync, then tune again.</source>
            <translation>The tap stands in the hole: turn it out in sync, then tune again.</translation>
        </message>
        <message>
            <source>The tap was aborted: the accepted gains are back in force.</source>
            <translation>The tap was aborted: the accepted gains are back in force.</translation>
        </message>
        <message>
            <source>The tapping job has a value outside its range.</source>
            <translation>The tapping job has a value outside its range.</translation>
        </message>
        <message>
            <source>The tapping loop does not know this command.</source>
            <translation>The tapping loop does not know this command.</translation>
        </message>
        <message>
            <source>The tapping program needs pitch, revolutions and speed above zero.</source>
            <translation>The tapping program needs pitch, revolutions and speed above zero.</translation>
        </message>
        <message>
            <source>The tuner does not learn from it.</source>
            <translation>The tuner does not learn from it.</translation>
        </message>
        <message>
            <source>The wall stays flat, but the feed falls with the wear and the tool may break.</source>
            <translation>The wall stays flat, but the feed falls with the wear and the tool may break.</translation>
        </message>
        <message>
            <source>This machine has no force sensor.</source>
            <translation>This machine has no force sensor.</translation>
        </message>
        <message>
            <source>This recipe revision cannot be read: it is no list of parameters.</source>
            <translation>This recipe revision cannot be read: it is no list of parameters.</translation>
        </message>
        <message>
            <source>This thread is not in the table.</source>
            <translation>This thread is not in the table.</translation>
        </message>
        <message>
            <source>Threads are still made; their tolerance is used up slowly.</source>
            <translation>Threads are still made; their tolerance is used up slowly.</translation>
        </message>
        <message>
            <source>Tool broken?</source>
            <translation>Tool broken?</translation>
        </message>
        <message>
            <source>Tool radius</source>
            <translation>Tool radius</translation>
        </message>
        <message>
            <source>Tool wear above its threshold</source>
            <translation>Tool wear above its threshold</translation>
        </message>
        <message>
            <source>Wear threshold</source>
            <translation>Wear threshold</translation>
        </message>
        <message>
            <source>Wrong pitch</source>
            <translation>Wrong pitch</translation>
        </message>
        <message>
            <source>Z and spindle were further apart than the abort limit during a tap.</source>
            <translation>Z and spindle were further apart than the abort limit during a tap.</translation>
        </message>
        <message>
            <source>Z moves %1 mm per revolution, the pitch entered is %2 mm.</source>
            <translation>Z moves %1 mm per revolution, the pitch entered is %2 mm.</translation>
        </message>
        <message>
            <source>Z moves by another distance per revolution than the pitch entered.</source>
            <translation>Z moves by another distance per revolution than the pitch entered.</translation>
        </message>
        <message>
            <source>Cutting stiffness ln(C b)</source>
            <translation>Cutting stiffness ln(C b)</translation>
        </message>
        <message>
            <source>Largest trim</source>
            <translation>Largest trim</translation>
        </message>
        <message>
            <source>Mean force</source>
            <translation>Mean force</translation>
        </message>
        <message>
            <source>On the built-in diamond lathe: start the console with --machine diamond-lathe.</source>
            <translation>On the built-in diamond lathe: start the console with --machine diamond-lathe.</translation>
        </message>
        <message>
            <source>On the built-in machining centre: start the console with --machine simulator.</source>
            <translation>On the built-in machining centre: start the console with --machine simulator.</translation>
        </message>
        <message>
            <source>Peak at</source>
            <translation>Peak at</translation>
        </message>
        <message>
            <source>Peak force</source>
            <translation>Peak force</translation>
        </message>
        <message>
            <source>Surface P-V</source>
            <translation>Surface P-V</translation>
        </message>
        <message>
            <source>Surface RMS</source>
            <translation>Surface RMS</translation>
        </message>
        <message>
            <source>Time at planned feed</source>
            <translation>Time at planned feed</translation>
        </message>
        <message>
            <source>Time cut</source>
            <translation>Time cut</translation>
        </message>
        <message>
            <source>Time under control</source>
            <translation>Time under control</translation>
        </message>
        <message>
            <source>Waviness</source>
            <translation>Waviness</translation>
        </message>
        <message>
            <source>Without the loop</source>
            <translation>Without the loop</translation>
        </message>
        <message>
            <source>A lot has at most %1 parts.</source>
            <translation>A lot has at most %1 parts.</translation>
        </message>
        <message>
            <source>A lot needs a name or number.</source>
            <translation>A lot needs a name or number.</translation>
        </message>
        <message>
            <source>A part of this lot is being bored; change the lot when it is finished.</source>
            <translation>A part of this lot is being bored; change the lot when it is finished.</translation>
        </message>
        <message>
            <source>A part type needs a name.</source>
            <translation>A part type needs a name.</translation>
        </message>
        <message>
            <source>A recipe needs %1 numbers.</source>
            <translation>A recipe needs %1 numbers.</translation>
        </message>
        <message>
            <source>Overhang where the bore is measured</source>
            <translation>Overhang where the bore is measured</translation>
        </message>
        <message>
            <source>Parts in the lot</source>
            <translation>Parts in the lot</translation>
        </message>
        <message>
            <source>There is a lot of this name for the part type already; give another name.</source>
            <translation>There is a lot of this name for the part type already; give another name.</translation>
        </message>
        <message>
            <source>There is a part type of this name already; give another name.</source>
            <translation>There is a part type of this name already; give another name.</translation>
        </message>
        <message>
            <source>There is no such part type.</source>
            <translation>There is no such part type.</translation>
        </message>
        <message>
            <source>This change needs a reason.</source>
            <translation>This change needs a reason.</translation>
        </message>
        <message>
            <source>work order</source>
            <translation>work order</translation>
        </message>
        <message>
            <source>%1 rows; a blank profile needs from 2 to %2, the last one ends the blank.</source>
            <translation>%1 rows; a blank profile needs from 2 to %2, the last one ends the blank.</translation>
        </message>
        <message>
            <source>Blank ends at</source>
            <translation>Blank ends at</translation>
        </message>
        <message>
            <source>Height of the step</source>
            <translation>Height of the step</translation>
        </message>
        <message>
            <source>Its 95 % half width</source>
            <translation>Its 95 % half width</translation>
        </message>
        <message>
            <source>Line %1, column %2: “%3” is not a number.</source>
            <translation>Line %1, column %2: “%3” is not a number.</translation>
        </message>
        <message>
            <source>Line %1, column height_mm: %2 mm must be from 0 to %3 mm.</source>
            <translation>Line %1, column height_mm: %2 mm must be from 0 to %3 mm.</translation>
        </message>
        <message>
            <source>Line %1, column x_mm: %2 mm must lie beyond the step before, %3 mm.</source>
            <translation>Line %1, column x_mm: %2 mm must lie beyond the step before, %3 mm.</translation>
        </message>
        <message>
            <source>Line %1: %2 columns, expected are 2: x_mm,height_mm.</source>
            <translation>Line %1: %2 columns, expected are 2: x_mm,height_mm.</translation>
        </message>
        <message>
            <source>Line %1: the first line must name the columns x_mm,height_mm.</source>
            <translation>Line %1: the first line must name the columns x_mm,height_mm.</translation>
        </message>
        <message>
            <source>Oh and Jeong (1987)</source>
            <translation>Oh and Jeong (1987)</translation>
        </message>
        <message>
            <source>Saved</source>
            <translation>Saved</translation>
        </message>
        <message>
            <source>Sign on first: a change needs a name.</source>
            <translation>Sign on first: a change needs a name.</translation>
        </message>
        <message>
            <source>Step begins at</source>
            <translation>Step begins at</translation>
        </message>
        <message>
            <source>Stops by the loop</source>
            <translation>Stops by the loop</translation>
        </message>
        <message>
            <source>The feed is not controlled: it stays, or falls to the planned feed if it was faster. Overload and breakage are not noticed.</source>
            <translation>The feed is not controlled: it stays, or falls to the planned feed if it was faster. Overload and breakage are not noticed.</translation>
        </message>
        <message>
            <source>The file cannot be read. Check its name and folder.</source>
            <translation>The file cannot be read. Check its name and folder.</translation>
        </message>
        <message>
            <source>The file is too large for a blank profile.</source>
            <translation>The file is too large for a blank profile.</translation>
        </message>
        <message>
            <source>The stored state of the tool cannot be used.</source>
            <translation>The stored state of the tool cannot be used.</translation>
        </message>
        <message>
            <source>Time above reference</source>
            <translation>Time above reference</translation>
        </message>
        <message>
            <source>What was stored for milling cannot be read.</source>
            <translation>What was stored for milling cannot be read.</translation>
        </message>
        <message>
            <source>calibrated on the published cuts</source>
            <translation>calibrated on the published cuts</translation>
        </message>
        <message>
            <source>part program</source>
            <translation>part program</translation>
        </message>
        <message>
            <source>Depth of cut</source>
            <translation>Depth of cut</translation>
        </message>
        <message>
            <source>Face from</source>
            <translation>Face from</translation>
        </message>
        <message>
            <source>Face to</source>
            <translation>Face to</translation>
        </message>
        <message>
            <source>Feed per revolution</source>
            <translation>Feed per revolution</translation>
        </message>
        <message>
            <source>Jeong &amp; Kim: the cut in copper</source>
            <translation>Jeong &amp; Kim: the cut in copper</translation>
        </message>
        <message>
            <source>Known tone</source>
            <translation>Known tone</translation>
        </message>
        <message>
            <source>Open: the disturbance is watched, the tool is not trimmed.</source>
            <translation>Open: the disturbance is watched, the tool is not trimmed.</translation>
        </message>
        <message>
            <source>P-V, second half</source>
            <translation>P-V, second half</translation>
        </message>
        <message>
            <source>RMS, second half</source>
            <translation>RMS, second half</translation>
        </message>
        <message>
            <source>The mean force has fallen: no trim in this part.</source>
            <translation>The mean force has fallen: no trim in this part.</translation>
        </message>
        <message>
            <source>The mean of the trim is %1 um.</source>
            <translation>The mean of the trim is %1 um.</translation>
        </message>
        <message>
            <source>The trim follows the depth error.</source>
            <translation>The trim follows the depth error.</translation>
        </message>
        <message>
            <source>The turning loop does not know this controller.</source>
            <translation>The turning loop does not know this controller.</translation>
        </message>
        <message>
            <source>Touch-off</source>
            <translation>Touch-off</translation>
        </message>
        <message>
            <source>Trim authority</source>
            <translation>Trim authority</translation>
        </message>
        <message>
            <source>Under control</source>
            <translation>Under control</translation>
        </message>
        <message>
            <source>this machine</source>
            <translation>this machine</translation>
        </message>
        <message>
            <source>%1 taps in a row did not count: check the encoders.</source>
            <translation>%1 taps in a row did not count: check the encoders.</translation>
        </message>
        <message>
            <source>Error RMS</source>
            <translation>Error RMS</translation>
        </message>
        <message>
            <source>Error p-p in the work</source>
            <translation>Error p-p in the work</translation>
        </message>
        <message>
            <source>In control the tap is turned out in sync and the gains are rolled back. The thread may be torn.</source>
            <translation>In control the tap is turned out in sync and the gains are rolled back. The thread may be torn.</translation>
        </message>
        <message>
            <source>In control the tap is turned out in sync.</source>
            <translation>In control the tap is turned out in sync.</translation>
        </message>
        <message>
            <source>In control the tap is turned out in sync. It does not count.</source>
            <translation>In control the tap is turned out in sync. It does not count.</translation>
        </message>
        <message>
            <source>Largest error</source>
            <translation>Largest error</translation>
        </message>
        <message>
            <source>More than 5 % of its samples are missing, or the loop was switched during the tap.</source>
            <translation>More than 5 % of its samples are missing, or the loop was switched during the tap.</translation>
        </message>
        <message>
            <source>Sum of errors (SAEC)</source>
            <translation>Sum of errors (SAEC)</translation>
        </message>
        <message>
            <source>The control did not start the tapping program.</source>
            <translation>The control did not start the tapping program.</translation>
        </message>
        <message>
            <source>The depth must be from 1 to 200 revolutions.</source>
            <translation>The depth must be from 1 to 200 revolutions.</translation>
        </message>
        <message>
            <source>The drive did not take the gains.</source>
            <translation>The drive did not take the gains.</translation>
        </message>
        <message>
            <source>The gear must be from 1 to 9.</source>
            <translation>The gear must be from 1 to 9.</translation>
        </message>
        <message>
            <source>The last tap does not count: repeat it.</source>
            <translation>The last tap does not count: repeat it.</translation>
        </message>
        <message>
            <source>The learned trim of these gains is not loaded.</source>
            <translation>The learned trim of these gains is not loaded.</translation>
        </message>
        <message>
            <source>The loop was switched before the tap began.</source>
            <translation>The loop was switched before the tap began.</translation>
        </message>
        <message>
            <source>The spindle speed must be from 10 to 20000 rpm.</source>
            <translation>The spindle speed must be from 10 to 20000 rpm.</translation>
        </message>
        <message>
            <source>The tap was called off before it began.</source>
            <translation>The tap was called off before it began.</translation>
        </message>
        <message>
            <source>The tapping loop is off: switch it to advise or control to abort the tap.</source>
            <translation>The tapping loop is off: switch it to advise or control to abort the tap.</translation>
        </message>
        <message>
            <source>This tap takes %1 s; at most %2 s can be recorded: a higher speed or less depth.</source>
            <translation>This tap takes %1 s; at most %2 s can be recorded: a higher speed or less depth.</translation>
        </message>
        <message>
            <source>Tolerance used</source>
            <translation>Tolerance used</translation>
        </message>
        <message>
            <source>A day cannot be used; nothing has changed.</source>
            <translation>A day cannot be used; nothing has changed.</translation>
        </message>
        <message>
            <source>A gap sensor's zero is not a number.</source>
            <translation>A gap sensor's zero is not a number.</translation>
        </message>
        <message>
            <source>A model is being trained.</source>
            <translation>A model is being trained.</translation>
        </message>
        <message>
            <source>A session is being recorded.</source>
            <translation>A session is being recorded.</translation>
        </message>
        <message>
            <source>A thermocouple is left out</source>
            <translation>A thermocouple is left out</translation>
        </message>
        <message>
            <source>Check its plug and its mounting.</source>
            <translation>Check its plug and its mounting.</translation>
        </message>
        <message>
            <source>Check that external work offset is allowed at the control.</source>
            <translation>Check that external work offset is allowed at the control.</translation>
        </message>
        <message>
            <source>Check the temperature module and its cable.</source>
            <translation>Check the temperature module and its cable.</translation>
        </message>
        <message>
            <source>Choose at least one day to train on.</source>
            <translation>Choose at least one day to train on.</translation>
        </message>
        <message>
            <source>Drift faster than the shift may follow</source>
            <translation>Drift faster than the shift may follow</translation>
        </message>
        <message>
            <source>Error the part allows</source>
            <translation>Error the part allows</translation>
        </message>
        <message>
            <source>It is open, shorted, stuck, noisy or away from what its neighbours expect.</source>
            <translation>It is open, shorted, stuck, noisy or away from what its neighbours expect.</translation>
        </message>
        <message>
            <source>Largest shift</source>
            <translation>Largest shift</translation>
        </message>
        <message>
            <source>Largest shift in a minute</source>
            <translation>Largest shift in a minute</translation>
        </message>
        <message>
            <source>Look at the thermocouples: heat does not move that fast.</source>
            <translation>Look at the thermocouples: heat does not move that fast.</translation>
        </message>
        <message>
            <source>Measure the origin now</source>
            <translation>Measure the origin now</translation>
        </message>
        <message>
            <source>Measure the origin, then set it anew or allow a larger shift.</source>
            <translation>Measure the origin, then set it anew or allow a larger shift.</translation>
        </message>
        <message>
            <source>Measure the origin; record this state and train again.</source>
            <translation>Measure the origin; record this state and train again.</translation>
        </message>
        <message>
            <source>More than two of the model's own thermocouples are left out.</source>
            <translation>More than two of the model's own thermocouples are left out.</translation>
        </message>
        <message>
            <source>No session is being recorded.</source>
            <translation>No session is being recorded.</translation>
        </message>
        <message>
            <source>No temperatures from the machine</source>
            <translation>No temperatures from the machine</translation>
        </message>
        <message>
            <source>Nothing can be predicted: too many thermocouples are left out.</source>
            <translation>Nothing can be predicted: too many thermocouples are left out.</translation>
        </message>
        <message>
            <source>Nothing has been measured yet.</source>
            <translation>Nothing has been measured yet.</translation>
        </message>
        <message>
            <source>Nothing is predicted; the last shift stays.</source>
            <translation>Nothing is predicted; the last shift stays.</translation>
        </message>
        <message>
            <source>One of the days is not there any more.</source>
            <translation>One of the days is not there any more.</translation>
        </message>
        <message>
            <source>Outside the training range: the shift fades to hold. Measure the origin.</source>
            <translation>Outside the training range: the shift fades to hold. Measure the origin.</translation>
        </message>
        <message>
            <source>Put the test bar in and measure from the thermal page.</source>
            <translation>Put the test bar in and measure from the thermal page.</translation>
        </message>
        <message>
            <source>Repair the thermocouples named on the thermal page, or go live with a model without them.</source>
            <translation>Repair the thermocouples named on the thermal page, or go live with a model without them.</translation>
        </message>
        <message>
            <source>Shift of the work origin at its limit</source>
            <translation>Shift of the work origin at its limit</translation>
        </message>
        <message>
            <source>Temperatures outside the training range</source>
            <translation>Temperatures outside the training range</translation>
        </message>
        <message>
            <source>The compensation fades to hold the last shift.</source>
            <translation>The compensation fades to hold the last shift.</translation>
        </message>
        <message>
            <source>The control does not report its work offset; nothing is shifted.</source>
            <translation>The control does not report its work offset; nothing is shifted.</translation>
        </message>
        <message>
            <source>The control does not take the shift</source>
            <translation>The control does not take the shift</translation>
        </message>
        <message>
            <source>The drift is in the part.</source>
            <translation>The drift is in the part.</translation>
        </message>
        <message>
            <source>The gap sensors have no zero yet: take a reference first.</source>
            <translation>The gap sensors have no zero yet: take a reference first.</translation>
        </message>
        <message>
            <source>The gap sensors read nothing: end the program and put the test bar in the spindle.</source>
            <translation>The gap sensors read nothing: end the program and put the test bar in the spindle.</translation>
        </message>
        <message>
            <source>The gap sensors stopped reading during the measurement.</source>
            <translation>The gap sensors stopped reading during the measurement.</translation>
        </message>
        <message>
            <source>The interval of the prediction is wider than the part allows.</source>
            <translation>The interval of the prediction is wider than the part allows.</translation>
        </message>
        <message>
            <source>The machine is in a state the model has never seen.</source>
            <translation>The machine is in a state the model has never seen.</translation>
        </message>
        <message>
            <source>The machine sends no temperatures any more.</source>
            <translation>The machine sends no temperatures any more.</translation>
        </message>
        <message>
            <source>The machine sends no temperatures; the last shift stays.</source>
            <translation>The machine sends no temperatures; the last shift stays.</translation>
        </message>
        <message>
            <source>The model goes on without it; its interval is wider.</source>
            <translation>The model goes on without it; its interval is wider.</translation>
        </message>
        <message>
            <source>The new model runs through the day so far.</source>
            <translation>The new model runs through the day so far.</translation>
        </message>
        <message>
            <source>The origin is being measured.</source>
            <translation>The origin is being measured.</translation>
        </message>
        <message>
            <source>The predicted drift is larger than the largest shift allowed.</source>
            <translation>The predicted drift is larger than the largest shift allowed.</translation>
        </message>
        <message>
            <source>The predicted drift moves faster than the rate allowed.</source>
            <translation>The predicted drift moves faster than the rate allowed.</translation>
        </message>
        <message>
            <source>The rest of the drift is in the part.</source>
            <translation>The rest of the drift is in the part.</translation>
        </message>
        <message>
            <source>The shift lags behind for some minutes.</source>
            <translation>The shift lags behind for some minutes.</translation>
        </message>
        <message>
            <source>The shift may be wrong by more than the part allows.</source>
            <translation>The shift may be wrong by more than the part allows.</translation>
        </message>
        <message>
            <source>The shift sits at its limit of size or rate.</source>
            <translation>The shift sits at its limit of size or rate.</translation>
        </message>
        <message>
            <source>The temperatures to count from are being taken; the shift stays.</source>
            <translation>The temperatures to count from are being taken; the shift stays.</translation>
        </message>
        <message>
            <source>The thermal loop does not know this command.</source>
            <translation>The thermal loop does not know this command.</translation>
        </message>
        <message>
            <source>The thermal setup has a value outside its range; the last one stays.</source>
            <translation>The thermal setup has a value outside its range; the last one stays.</translation>
        </message>
        <message>
            <source>The warm-up program needs speed and revolutions above zero.</source>
            <translation>The warm-up program needs speed and revolutions above zero.</translation>
        </message>
        <message>
            <source>The work offset the control reports is not the one commanded.</source>
            <translation>The work offset the control reports is not the one commanded.</translation>
        </message>
        <message>
            <source>The work origin follows the predicted drift.</source>
            <translation>The work origin follows the predicted drift.</translation>
        </message>
        <message>
            <source>There is no measurement beside a prediction yet.</source>
            <translation>There is no measurement beside a prediction yet.</translation>
        </message>
        <message>
            <source>There is no model before this one.</source>
            <translation>There is no model before this one.</translation>
        </message>
        <message>
            <source>There is no thermal model yet: train one.</source>
            <translation>There is no thermal model yet: train one.</translation>
        </message>
        <message>
            <source>There is no trained model that waits to go live.</source>
            <translation>There is no trained model that waits to go live.</translation>
        </message>
        <message>
            <source>Thermocouple %1 disagrees with its neighbours.</source>
            <translation>Thermocouple %1 disagrees with its neighbours.</translation>
        </message>
        <message>
            <source>Thermocouple %1 has jumped away from its neighbours.</source>
            <translation>Thermocouple %1 has jumped away from its neighbours.</translation>
        </message>
        <message>
            <source>Thermocouple %1 is noisy.</source>
            <translation>Thermocouple %1 is noisy.</translation>
        </message>
        <message>
            <source>Thermocouple %1 is open.</source>
            <translation>Thermocouple %1 is open.</translation>
        </message>
        <message>
            <source>Thermocouple %1 is shorted.</source>
            <translation>Thermocouple %1 is shorted.</translation>
        </message>
        <message>
            <source>Thermocouple %1 is stuck.</source>
            <translation>Thermocouple %1 is stuck.</translation>
        </message>
        <message>
            <source>This machine has no thermocouple %1; %2 of the model's %3 are missing.</source>
            <translation>This machine has no thermocouple %1; %2 of the model's %3 are missing.</translation>
        </message>
        <message>
            <source>This measurement has been taken over already.</source>
            <translation>This measurement has been taken over already.</translation>
        </message>
        <message>
            <source>Time between two shifts</source>
            <translation>Time between two shifts</translation>
        </message>
        <message>
            <source>Too many thermocouples lost</source>
            <translation>Too many thermocouples lost</translation>
        </message>
        <message>
            <source>Warm-up speed</source>
            <translation>Warm-up speed</translation>
        </message>
        <message>
            <source>Warm-up time</source>
            <translation>Warm-up time</translation>
        </message>
        <message>
            <source>X screw</source>
            <translation>X screw</translation>
        </message>
        <message>
            <source>Y screw</source>
            <translation>Y screw</translation>
        </message>
        <message>
            <source>Z screw</source>
            <translation>Z screw</translation>
        </message>
        <message>
            <source>bed</source>
            <translation>bed</translation>
        </message>
        <message>
            <source>column, back</source>
            <translation>column, back</translation>
        </message>
        <message>
            <source>column, foot</source>
            <translation>column, foot</translation>
        </message>
        <message>
            <source>column, left</source>
            <translation>column, left</translation>
        </message>
        <message>
            <source>column, right</source>
            <translation>column, right</translation>
        </message>
        <message>
            <source>column, top</source>
            <translation>column, top</translation>
        </message>
        <message>
            <source>front bearing</source>
            <translation>front bearing</translation>
        </message>
        <message>
            <source>head, left</source>
            <translation>head, left</translation>
        </message>
        <message>
            <source>head, right</source>
            <translation>head, right</translation>
        </message>
        <message>
            <source>quill</source>
            <translation>quill</translation>
        </message>
        <message>
            <source>rear bearing</source>
            <translation>rear bearing</translation>
        </message>
        <message>
            <source>room</source>
            <translation>room</translation>
        </message>
        <message>
            <source>saddle</source>
            <translation>saddle</translation>
        </message>
        <message>
            <source>shaft</source>
            <translation>shaft</translation>
        </message>
        <message>
            <source>spindle motor</source>
            <translation>spindle motor</translation>
        </message>
        <message>
            <source>table</source>
            <translation>table</translation>
        </message>
        <message>
            <source>A subroutine needs a name of letters, digits and underscores, a number from 1 to 9999 and a deviation from 0.001 to 0.1.</source>
            <translation>A subroutine needs a name of letters, digits and underscores, a number from 1 to 9999 and a deviation from 0.001 to 0.1.</translation>
        </message>
        <message>
            <source>Diamond turning trims the tool every 0.2 ms; this control moves once per ms.</source>
            <translation>Diamond turning trims the tool every 0.2 ms; this control moves once per ms.</translation>
        </message>
        <message>
            <source>LinuxCNC has not been reached yet: what it can do is not known.</source>
            <translation>LinuxCNC has not been reached yet: what it can do is not known.</translation>
        </message>
        <message>
            <source>Matched gain %1 1/s and feed-forward %2: %3 mm expected.</source>
            <translation>Matched gain %1 1/s and feed-forward %2: %3 mm expected.</translation>
        </message>
        <message>
            <source>The gains do not read back from the control.</source>
            <translation>The gains do not read back from the control.</translation>
        </message>
        <message>
            <source>The gains of Z cannot be set on this LinuxCNC: add kerf-tapping.hal.</source>
            <translation>The gains of Z cannot be set on this LinuxCNC: add kerf-tapping.hal.</translation>
        </message>
        <message>
            <source>The schedule has a value outside its range: feeds, overhangs, speed and alpha above zero.</source>
            <translation>The schedule has a value outside its range: feeds, overhangs, speed and alpha above zero.</translation>
        </message>
        <message>
            <source>The schedule needs more than %1 segments: allow a larger deviation.</source>
            <translation>The schedule needs more than %1 segments: allow a larger deviation.</translation>
        </message>
        <message>
            <source>The spindle's gain cannot be set on this control, only Z's.</source>
            <translation>The spindle's gain cannot be set on this control, only Z's.</translation>
        </message>
        <message>
            <source>The tapping program needs pitch and speed above zero and more than %1 revolutions.</source>
            <translation>The tapping program needs pitch and speed above zero and more than %1 revolutions.</translation>
        </message>
        <message>
            <source>This LinuxCNC brings no cutting force: no sensor is connected.</source>
            <translation>This LinuxCNC brings no cutting force: no sensor is connected.</translation>
        </message>
        <message>
            <source>This LinuxCNC brings no temperatures: without them nothing can be predicted.</source>
            <translation>This LinuxCNC brings no temperatures: without them nothing can be predicted.</translation>
        </message>
        <message>
            <source>This control cannot turn a standing tap out in sync: turn spindle and Z back by hand at the control, one pitch per revolution.</source>
            <translation>This control cannot turn a standing tap out in sync: turn spindle and Z back by hand at the control, one pitch per revolution.</translation>
        </message>
        <message>
            <source>What is left (%1 mm) is not a matter of gain or feed-forward.</source>
            <translation>What is left (%1 mm) is not a matter of gain or feed-forward.</translation>
        </message>
        <message>
            <source>%1 parts are too few for indices; they begin at %2.</source>
            <translation>%1 parts are too few for indices; they begin at %2.</translation>
        </message>
        <message>
            <source>%1 readings are too few; a type 1 study needs %2.</source>
            <translation>%1 readings are too few; a type 1 study needs %2.</translation>
        </message>
        <message>
            <source>15 in a row within 1σ</source>
            <translation>15 in a row within 1σ</translation>
        </message>
        <message>
            <source>2 of 3 beyond 2σ</source>
            <translation>2 of 3 beyond 2σ</translation>
        </message>
        <message>
            <source>4 of 5 beyond 1σ</source>
            <translation>4 of 5 beyond 1σ</translation>
        </message>
        <message>
            <source>8 in a row beyond 1σ</source>
            <translation>8 in a row beyond 1σ</translation>
        </message>
        <message>
            <source>8 in a row on one side</source>
            <translation>8 in a row on one side</translation>
        </message>
        <message>
            <source>9 in a row on one side</source>
            <translation>9 in a row on one side</translation>
        </message>
        <message>
            <source>A crossed study needs at least 2 parts, 2 persons and 2 trials; it has %1, %2, %3.</source>
            <translation>A crossed study needs at least 2 parts, 2 persons and 2 trials; it has %1, %2, %3.</translation>
        </message>
        <message>
            <source>All readings are alike: the gauge is stuck, or too coarse for a study.</source>
            <translation>All readings are alike: the gauge is stuck, or too coarse for a study.</translation>
        </message>
        <message>
            <source>All values are alike, so there are no indices: is the gauge too coarse?</source>
            <translation>All values are alike, so there are no indices: is the gauge too coarse?</translation>
        </message>
        <message>
            <source>Average and range takes at most %1 parts, persons or trials; use ANOVA.</source>
            <translation>Average and range takes at most %1 parts, persons or trials; use ANOVA.</translation>
        </message>
        <message>
            <source>Field %1 of the model file has an unknown value.</source>
            <translation>Field %1 of the model file has an unknown value.</translation>
        </message>
        <message>
            <source>Field %1 of the model file has the wrong length.</source>
            <translation>Field %1 of the model file has the wrong length.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is not a finite number.</source>
            <translation>Field %1 of the model file is not a finite number.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is not a range from low to high.</source>
            <translation>Field %1 of the model file is not a range from low to high.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is not a text.</source>
            <translation>Field %1 of the model file is not a text.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is not a whole number in range.</source>
            <translation>Field %1 of the model file is not a whole number in range.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is out of range.</source>
            <translation>Field %1 of the model file is out of range.</translation>
        </message>
        <message>
            <source>Field %1 of the stored tuning is out of range.</source>
            <translation>Field %1 of the stored tuning is out of range.</translation>
        </message>
        <message>
            <source>The model file has another unit of %1; expected %2.</source>
            <translation>The model file has another unit of %1; expected %2.</translation>
        </message>
        <message>
            <source>The model file has no field %1.</source>
            <translation>The model file has no field %1.</translation>
        </message>
        <message>
            <source>The model file has version %1; this program reads up to version %2. Use a newer program.</source>
            <translation>The model file has version %1; this program reads up to version %2. Use a newer program.</translation>
        </message>
        <message>
            <source>The model file is damaged.</source>
            <translation>The model file is damaged.</translation>
        </message>
        <message>
            <source>The residual chart shows a signal: these parts performed so, but it is no capability.</source>
            <translation>The residual chart shows a signal: these parts performed so, but it is no capability.</translation>
        </message>
        <message>
            <source>The stored tuning has no field %1.</source>
            <translation>The stored tuning has no field %1.</translation>
        </message>
        <message>
            <source>The stored tuning is not JSON.</source>
            <translation>The stored tuning is not JSON.</translation>
        </message>
        <message>
            <source>The stored tuning is of another version.</source>
            <translation>The stored tuning is of another version.</translation>
        </message>
        <message>
            <source>The study is not crossed: part %1, person %2, trial %3 must stand there once.</source>
            <translation>The study is not crossed: part %1, person %2, trial %3 must stand there once.</translation>
        </message>
        <message>
            <source>The tolerance must be above 0; it is %1.</source>
            <translation>The tolerance must be above 0; it is %1.</translation>
        </message>
        <message>
            <source>There is no tolerance, so there are no indices.</source>
            <translation>There is no tolerance, so there are no indices.</translation>
        </message>
        <message>
            <source>This is not a thermal model file.</source>
            <translation>This is not a thermal model file.</translation>
        </message>
        <message>
            <source>one beyond 3σ</source>
            <translation>one beyond 3σ</translation>
        </message>
        <message>
            <source>The shop has been out of reach for %1 min; %2 entries wait here.</source>
            <translation>The shop has been out of reach for %1 min; %2 entries wait here.</translation>
        </message>
        <message>
            <source>%1 finished parts are not recorded.</source>
            <translation>%1 finished parts are not recorded.</translation>
        </message>
        <message>
            <source>%1 finished parts had waited beside the data file; they are stored now.</source>
            <translation>%1 finished parts had waited beside the data file; they are stored now.</translation>
        </message>
        <message>
            <source>%1 items that waited beside the data file are of another version: they are kept in a file beside it.</source>
            <translation>%1 items that waited beside the data file are of another version: they are kept in a file beside it.</translation>
        </message>
        <message>
            <source>%1 setups, tunings and models were kept, %2 are stored.</source>
            <translation>%1 setups, tunings and models were kept, %2 are stored.</translation>
        </message>
        <message>
            <source>A finished part was not recorded</source>
            <translation>A finished part was not recorded</translation>
        </message>
        <message>
            <source>A part was begun at the control while finished parts could not be stored, and there is no place left to keep them.</source>
            <translation>A part was begun at the control while finished parts could not be stored, and there is no place left to keep them.</translation>
        </message>
        <message>
            <source>Audit entry %1 is not the one that had been written: this is another file.</source>
            <translation>Audit entry %1 is not the one that had been written: this is another file.</translation>
        </message>
        <message>
            <source>Begin no part at the control until storing goes on. Note these parts down by hand.</source>
            <translation>Begin no part at the control until storing goes on. Note these parts down by hand.</translation>
        </message>
        <message>
            <source>One of the first %1 kept setups, tunings or models was changed after it was kept.</source>
            <translation>One of the first %1 kept setups, tunings or models was changed after it was kept.</translation>
        </message>
        <message>
            <source>Only a process engineer may do this.</source>
            <translation>Only a process engineer may do this.</translation>
        </message>
        <message>
            <source>Only a setter or a process engineer may do this.</source>
            <translation>Only a setter or a process engineer may do this.</translation>
        </message>
        <message>
            <source>Recipe revision %1 differs from what was logged when it was saved.</source>
            <translation>Recipe revision %1 differs from what was logged when it was saved.</translation>
        </message>
        <message>
            <source>Record %1 (%2) differs from what was logged when it was kept.</source>
            <translation>Record %1 (%2) differs from what was logged when it was kept.</translation>
        </message>
        <message>
            <source>Setting %1 differs from what was logged when it was changed.</source>
            <translation>Setting %1 differs from what was logged when it was changed.</translation>
        </message>
        <message>
            <source>The JSON holds %1; numbers are expected within ±1e60.</source>
            <translation>The JSON holds %1; numbers are expected within ±1e60.</translation>
        </message>
        <message>
            <source>The JSON holds a number too large to be stored; numbers are expected within ±1e60.</source>
            <translation>The JSON holds a number too large to be stored; numbers are expected within ±1e60.</translation>
        </message>
        <message>
            <source>The JSON is nested deeper than %1 levels.</source>
            <translation>The JSON is nested deeper than %1 levels.</translation>
        </message>
        <message>
            <source>The data file was deleted, moved or replaced while Kerf runs: nothing is stored. Put it back, or end Kerf and start it anew; what waits is kept beside it.</source>
            <translation>The data file was deleted, moved or replaced while Kerf runs: nothing is stored. Put it back, or end Kerf and start it anew; what waits is kept beside it.</translation>
        </message>
        <message>
            <source>The newest entries are missing: %1 had been written to the audit log, it ends at %2. A log file (-wal) was cut or deleted, or an older copy was put back.</source>
            <translation>The newest entries are missing: %1 had been written to the audit log, it ends at %2. A log file (-wal) was cut or deleted, or an older copy was put back.</translation>
        </message>
        <message>
            <source>The newest rows of %1 are missing: %2 had been written, %3 are left. A log file (-wal) was cut or deleted, or an older copy was put back.</source>
            <translation>The newest rows of %1 are missing: %2 had been written, %3 are left. A log file (-wal) was cut or deleted, or an older copy was put back.</translation>
        </message>
        <message>
            <source>This is not JSON: no valid JSON at byte %1.</source>
            <translation>This is not JSON: no valid JSON at byte %1.</translation>
        </message>
        <message>
            <source>This part and those after it stand nowhere: neither figures nor feed of them are kept.</source>
            <translation>This part and those after it stand nowhere: neither figures nor feed of them are kept.</translation>
        </message>
        <message>
            <source>An abort came first: this was not sent any more.</source>
            <translation>An abort came first: this was not sent any more.</translation>
        </message>
        <message>
            <source>Another program (process %1) commands this machine, this one only reads: end it, or take the machine over, and start this one anew.</source>
            <translation>Another program (process %1) commands this machine, this one only reads: end it, or take the machine over, and start this one anew.</translation>
        </message>
        <message>
            <source>LinuxCNC is not reached: there is nobody to take it over from.</source>
            <translation>LinuxCNC is not reached: there is nobody to take it over from.</translation>
        </message>
        <message>
            <source>Others may read the file with the passwords of linuxcncrsh: give it mode 0600.</source>
            <translation>Others may read the file with the passwords of linuxcncrsh: give it mode 0600.</translation>
        </message>
        <message>
            <source>The control took the command, but no part began: see its own message (soft limit, tool, spindle).</source>
            <translation>The control took the command, but no part began: see its own message (soft limit, tool, spindle).</translation>
        </message>
        <message>
            <source>The file with the passwords of linuxcncrsh cannot be read.</source>
            <translation>The file with the passwords of linuxcncrsh cannot be read.</translation>
        </message>
        <message>
            <source>The file with the passwords of linuxcncrsh needs two lines: connect and enable.</source>
            <translation>The file with the passwords of linuxcncrsh needs two lines: connect and enable.</translation>
        </message>
        <message>
            <source>The units of this LinuxCNC are not known ([TRAJ]LINEAR_UNITS): Kerf commands nothing before it knows them.</source>
            <translation>The units of this LinuxCNC are not known ([TRAJ]LINEAR_UNITS): Kerf commands nothing before it knows them.</translation>
        </message>
        <message>
            <source>This LinuxCNC counts in inches ([TRAJ]LINEAR_UNITS): Kerf commands machines in mm only, and reads this one.</source>
            <translation>This LinuxCNC counts in inches ([TRAJ]LINEAR_UNITS): Kerf commands machines in mm only, and reads this one.</translation>
        </message>
        <message>
            <source>This machine is not shared: there is nobody to take it over from.</source>
            <translation>This machine is not shared: there is nobody to take it over from.</translation>
        </message>
        <message>
            <source>A move of Z or spindle alone breaks the tap. Kerf starts nothing and moves no axis until it is out.</source>
            <translation>A move of Z or spindle alone breaks the tap. Kerf starts nothing and moves no axis until it is out.</translation>
        </message>
        <message>
            <source>A stop stands from before: see the alarm.</source>
            <translation>A stop stands from before: see the alarm.</translation>
        </message>
        <message>
            <source>A stop stands: look at the machine, then release the stop.</source>
            <translation>A stop stands: look at the machine, then release the stop.</translation>
        </message>
        <message>
            <source>A tap stands in the hole, from before Kerf was started: turn it out in sync.</source>
            <translation>A tap stands in the hole, from before Kerf was started: turn it out in sync.</translation>
        </message>
        <message>
            <source>A tap stands in the hole: turn it out first, or say that it is gone.</source>
            <translation>A tap stands in the hole: turn it out first, or say that it is gone.</translation>
        </message>
        <message>
            <source>All loops are held. The control goes on with its last offset, at most at the planned feed; a program without one is held.</source>
            <translation>All loops are held. The control goes on with its last offset, at most at the planned feed; a program without one is held.</translation>
        </message>
        <message>
            <source>Called off before it began.</source>
            <translation>Called off before it began.</translation>
        </message>
        <message>
            <source>Check sensor, amplifier and cable. Measure this surface. Then release the stop.</source>
            <translation>Check sensor, amplifier and cable. Measure this surface. Then release the stop.</translation>
        </message>
        <message>
            <source>Check the control and the cable. Kerf connects again by itself; look at the machine, then release the hold.</source>
            <translation>Check the control and the cable. Kerf connects again by itself; look at the machine, then release the hold.</translation>
        </message>
        <message>
            <source>Find out why the spindle stopped. When it turns again, release the stop on the Milling page.</source>
            <translation>Find out why the spindle stopped. When it turns again, release the stop on the Milling page.</translation>
        </message>
        <message>
            <source>Kerf has come while a program runs: look at the machine, then release the hold.</source>
            <translation>Kerf has come while a program runs: look at the machine, then release the hold.</translation>
        </message>
        <message>
            <source>Look at the tool's edge. Change it if it is chipped, then release the stop.</source>
            <translation>Look at the tool's edge. Change it if it is chipped, then release the stop.</translation>
        </message>
        <message>
            <source>Look at tool and blank. If both are sound, raise the limit or lower the reference, then release the stop on the Milling page.</source>
            <translation>Look at tool and blank. If both are sound, raise the limit or lower the reference, then release the stop on the Milling page.</translation>
        </message>
        <message>
            <source>Make the machine ready, then turn the tap out in sync from the tapping page; or say there that it is gone.</source>
            <translation>Make the machine ready, then turn the tap out in sync from the tapping page; or say there that it is gone.</translation>
        </message>
        <message>
            <source>Make the machine safe, reset the emergency stop at the control, look, then release the hold.</source>
            <translation>Make the machine safe, reset the emergency stop at the control, look, then release the hold.</translation>
        </message>
        <message>
            <source>No connection to the machine: nothing was asked of it.</source>
            <translation>No connection to the machine: nothing was asked of it.</translation>
        </message>
        <message>
            <source>No connection to the machine: the last offset stays, the feed is at most the planned one, or held.</source>
            <translation>No connection to the machine: the last offset stays, the feed is at most the planned one, or held.</translation>
        </message>
        <message>
            <source>No stop stands here.</source>
            <translation>No stop stands here.</translation>
        </message>
        <message>
            <source>Programmed feed unknown: no faster than the schedule's lowest feed.</source>
            <translation>Programmed feed unknown: no faster than the schedule's lowest feed.</translation>
        </message>
        <message>
            <source>Retract and look at the tool. Change it if it is broken, then release the stop on the Milling page.</source>
            <translation>Retract and look at the tool. Change it if it is broken, then release the stop on the Milling page.</translation>
        </message>
        <message>
            <source>Sign on first: a stop is released by a person.</source>
            <translation>Sign on first: a stop is released by a person.</translation>
        </message>
        <message>
            <source>Spindle overhang unknown: no faster than the schedule's lowest feed.</source>
            <translation>Spindle overhang unknown: no faster than the schedule's lowest feed.</translation>
        </message>
        <message>
            <source>Spindle speed unknown or zero: no faster than the schedule's lowest feed.</source>
            <translation>Spindle speed unknown or zero: no faster than the schedule's lowest feed.</translation>
        </message>
        <message>
            <source>Stopped again since the release was asked: look once more.</source>
            <translation>Stopped again since the release was asked: look once more.</translation>
        </message>
        <message>
            <source>The connection was lost: look at the machine, then release the hold.</source>
            <translation>The connection was lost: look at the machine, then release the hold.</translation>
        </message>
        <message>
            <source>The connection was lost: no trim in the rest of this part.</source>
            <translation>The connection was lost: no trim in the rest of this part.</translation>
        </message>
        <message>
            <source>The control has ended the program. All loops are held until a person has looked; stops stay.</source>
            <translation>The control has ended the program. All loops are held until a person has looked; stops stay.</translation>
        </message>
        <message>
            <source>The feed falls to the lowest of the schedule and does not follow it, so the bore may taper.</source>
            <translation>The feed falls to the lowest of the schedule and does not follow it, so the bore may taper.</translation>
        </message>
        <message>
            <source>The feed is held: see the alarm, then release the stop.</source>
            <translation>The feed is held: see the alarm, then release the stop.</translation>
        </message>
        <message>
            <source>The machine was switched off: look at it, then release the hold.</source>
            <translation>The machine was switched off: look at it, then release the hold.</translation>
        </message>
        <message>
            <source>The trim has gone to zero; the cut goes on without force feedback. No part is started until a person has released the stop.</source>
            <translation>The trim has gone to zero; the cut goes on without force feedback. No part is started until a person has released the stop.</translation>
        </message>
        <message>
            <source>The trim has gone to zero; the surface after the jump is doubtful. No part is started until a person has released the stop.</source>
            <translation>The trim has gone to zero; the surface after the jump is doubtful. No part is started until a person has released the stop.</translation>
        </message>
        <message>
            <source>There was an emergency stop: look at the machine, then release the hold.</source>
            <translation>There was an emergency stop: look at the machine, then release the hold.</translation>
        </message>
        <message>
            <source>This loop may not ask the machine for that.</source>
            <translation>This loop may not ask the machine for that.</translation>
        </message>
        <message>
            <source>Too many requests wait for the machine.</source>
            <translation>Too many requests wait for the machine.</translation>
        </message>
        <message>
            <source>Under control the feed is held, in every mode from then on; advising, Kerf only reports it. Nothing is started until a person has released the stop.</source>
            <translation>Under control the feed is held, in every mode from then on; advising, Kerf only reports it. Nothing is started until a person has released the stop.</translation>
        </message>
        <message>
            <source>The table is in doubt: save it with ; between its columns, or with decimal points.</source>
            <translation>The table is in doubt: save it with ; between its columns, or with decimal points.</translation>
        </message>
        <message>
            <source>angle_rev turns %1 rev between samples; revolutions expected, at most %2 between samples. A column in degrees is named angle_deg.</source>
            <translation>angle_rev turns %1 rev between samples; revolutions expected, at most %2 between samples. A column in degrees is named angle_deg.</translation>
        </message>
        <message>
            <source>angle_rev means %1 rpm; at most %2 rpm are expected. A column in degrees is named angle_deg.</source>
            <translation>angle_rev means %1 rpm; at most %2 rpm are expected. A column in degrees is named angle_deg.</translation>
        </message>
        <message>
            <source>the spindle's angle jumps by %1 rev at sample %2; expected an angle that rises, falls or begins again after whole revolutions.</source>
            <translation>the spindle's angle jumps by %1 rev at sample %2; expected an angle that rises, falls or begins again after whole revolutions.</translation>
        </message>
        <message>
            <source>the spindle's angle does not move in the whole record.</source>
            <translation>the spindle's angle does not move in the whole record.</translation>
        </message>
        <message>
            <source>the spindle turns %1 rev one way and %2 rev the other; expected a cut in one direction.</source>
            <translation>the spindle turns %1 rev one way and %2 rev the other; expected a cut in one direction.</translation>
        </message>
        <message>
            <source>%1 is no figure of this process.</source>
            <translation>%1 is no figure of this process.</translation>
        </message>
        <message>
            <source>%1 parts on the charts: too few to say whether the process is in control.</source>
            <translation>%1 parts on the charts: too few to say whether the process is in control.</translation>
        </message>
        <message>
            <source>A change is announced for part %1: it begins from what such changes have brought.</source>
            <translation>A change is announced for part %1: it begins from what such changes have brought.</translation>
        </message>
        <message>
            <source>A gauge needs an identity.</source>
            <translation>A gauge needs an identity.</translation>
        </message>
        <message>
            <source>A part is being bored; announce the change when it is finished.</source>
            <translation>A part is being bored; announce the change when it is finished.</translation>
        </message>
        <message>
            <source>All repeated readings are alike: the gauge is stuck, or too coarse for a study.</source>
            <translation>All repeated readings are alike: the gauge is stuck, or too coarse for a study.</translation>
        </message>
        <message>
            <source>Begin from earlier lots (1 yes, 0 no)</source>
            <translation>Begin from earlier lots (1 yes, 0 no)</translation>
        </message>
        <message>
            <source>Expected from %1 earlier lots; the bending of a new tool differs by ± %2 % (1σ).</source>
            <translation>Expected from %1 earlier lots; the bending of a new tool differs by ± %2 % (1σ).</translation>
        </message>
        <message>
            <source>Expected from the %1 measured parts of this lot.</source>
            <translation>Expected from the %1 measured parts of this lot.</translation>
        </message>
        <message>
            <source>Expected from this lot and %1 earlier ones; after such a change the bending differs by ± %2 % (1σ).</source>
            <translation>Expected from this lot and %1 earlier ones; after such a change the bending differs by ± %2 % (1σ).</translation>
        </message>
        <message>
            <source>First part teaches (1 yes, 0 no)</source>
            <translation>First part teaches (1 yes, 0 no)</translation>
        </message>
        <message>
            <source>In control: the law predicts the parts, and the controller does not work harder.</source>
            <translation>In control: the law predicts the parts, and the controller does not work harder.</translation>
        </message>
        <message>
            <source>In control: the law predicts the parts. The controller has moved the feed by %1 % since part %2: the tool wears.</source>
            <translation>In control: the law predicts the parts. The controller has moved the feed by %1 % since part %2: the tool wears.</translation>
        </message>
        <message>
            <source>Not in control: %1 at part %2; look at tool, gauge and blank of that part.</source>
            <translation>Not in control: %1 at part %2; look at tool, gauge and blank of that part.</translation>
        </message>
        <message>
            <source>Nothing is known yet: the feed falls from %1 to %2 mm/rev near the bottom, so that this part shows what the feed does. Measure it in the middle too.</source>
            <translation>Nothing is known yet: the feed falls from %1 to %2 mm/rev near the bottom, so that this part shows what the feed does. Measure it in the middle too.</translation>
        </message>
        <message>
            <source>Nothing is measured in this lot yet: it begins from the lots before it.</source>
            <translation>Nothing is measured in this lot yet: it begins from the lots before it.</translation>
        </message>
        <message>
            <source>Part %1 contradicts what was expected from the past: the past is let go, the law learned anew.</source>
            <translation>Part %1 contradicts what was expected from the past: the past is let go, the law learned anew.</translation>
        </message>
        <message>
            <source>Prior: feed exponent α</source>
            <translation>Prior: feed exponent α</translation>
        </message>
        <message>
            <source>Prior: ln C</source>
            <translation>Prior: ln C</translation>
        </message>
        <message>
            <source>Prior: overhang exponent β</source>
            <translation>Prior: overhang exponent β</translation>
        </message>
        <message>
            <source>Prior: spread of the level</source>
            <translation>Prior: spread of the level</translation>
        </message>
        <message>
            <source>Prior: spread of α</source>
            <translation>Prior: spread of α</translation>
        </message>
        <message>
            <source>Prior: spread of β</source>
            <translation>Prior: spread of β</translation>
        </message>
        <message>
            <source>The first part of a lot counts as cut with a new tool already.</source>
            <translation>The first part of a lot counts as cut with a new tool already.</translation>
        </message>
        <message>
            <source>The limits of the figures cannot be read; they need numbers under their keys.</source>
            <translation>The limits of the figures cannot be read; they need numbers under their keys.</translation>
        </message>
        <message>
            <source>The lower limit of %1 must be below the upper one.</source>
            <translation>The lower limit of %1 must be below the upper one.</translation>
        </message>
        <message>
            <source>The range of a gauge must begin below its end, between 0 and 10000 mm.</source>
            <translation>The range of a gauge must begin below its end, between 0 and 10000 mm.</translation>
        </message>
        <message>
            <source>The resolution of a gauge lies above 0 and at most 1 mm.</source>
            <translation>The resolution of a gauge lies above 0 and at most 1 mm.</translation>
        </message>
        <message>
            <source>The setting ring must lie in the range of the gauge.</source>
            <translation>The setting ring must lie in the range of the gauge.</translation>
        </message>
        <message>
            <source>The trim follows what can be foreseen of the disturbance.</source>
            <translation>The trim follows what can be foreseen of the disturbance.</translation>
        </message>
        <message>
            <source>There is no such gauge.</source>
            <translation>There is no such gauge.</translation>
        </message>
        <message>
            <source>This lot does not begin from earlier ones; a change is found by its bores.</source>
            <translation>This lot does not begin from earlier ones; a change is found by its bores.</translation>
        </message>
        <message>
            <source>wide guess for any boring spindle about table 1 of Lee (1983)</source>
            <translation>wide guess for any boring spindle about table 1 of Lee (1983)</translation>
        </message>
        <message>
            <source>A recorded day is played: nothing can be commanded.</source>
            <translation>A recorded day is played: nothing can be commanded.</translation>
        </message>
        <message>
            <source>Jumped; believed again when three readings agree.</source>
            <translation>Jumped; believed again when three readings agree.</translation>
        </message>
        <message>
            <source>No answer: the module is off, its cable is out, or the address is wrong.</source>
            <translation>No answer: the module is off, its cable is out, or the address is wrong.</translation>
        </message>
        <message>
            <source>No drift was measured on that day.</source>
            <translation>No drift was measured on that day.</translation>
        </message>
        <message>
            <source>No signal is linked to the pin.</source>
            <translation>No signal is linked to the pin.</translation>
        </message>
        <message>
            <source>Not read yet.</source>
            <translation>Not read yet.</translation>
        </message>
        <message>
            <source>Outside what it can be: wrong type, scale or word order?</source>
            <translation>Outside what it can be: wrong type, scale or word order?</translation>
        </message>
        <message>
            <source>Reads.</source>
            <translation>Reads.</translation>
        </message>
        <message>
            <source>That is not on the picture.</source>
            <translation>That is not on the picture.</translation>
        </message>
        <message>
            <source>The control reports a fault of this channel.</source>
            <translation>The control reports a fault of this channel.</translation>
        </message>
        <message>
            <source>The module has no such register: another one than the sensor file says.</source>
            <translation>The module has no such register: another one than the sensor file says.</translation>
        </message>
        <message>
            <source>The module says that there is no measurement: the thermocouple is broken or loose.</source>
            <translation>The module says that there is no measurement: the thermocouple is broken or loose.</translation>
        </message>
        <message>
            <source>The module's status says that the value is not to be used.</source>
            <translation>The module's status says that the value is not to be used.</translation>
        </message>
        <message>
            <source>The reading process does not run; it is started again.</source>
            <translation>The reading process does not run; it is started again.</translation>
        </message>
        <message>
            <source>The reading process kerf-sensors cannot be started: it is not beside the program, or the computer has no room for it.</source>
            <translation>The reading process kerf-sensors cannot be started: it is not beside the program, or the computer has no room for it.</translation>
        </message>
        <message>
            <source>The recorded day is refused; the log says where and why.</source>
            <translation>The recorded day is refused; the log says where and why.</translation>
        </message>
        <message>
            <source>The register holds no number: are its words swapped?</source>
            <translation>The register holds no number: are its words swapped?</translation>
        </message>
        <message>
            <source>The sensor file is refused; `kerf sensors check` says where and why.</source>
            <translation>The sensor file is refused; `kerf sensors check` says where and why.</translation>
        </message>
        <message>
            <source>nothing takes a connection there; expected a Modbus TCP module that is switched on.</source>
            <translation>nothing takes a connection there; expected a Modbus TCP module that is switched on.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: Z reaches only %3 rev/s² and cannot follow the programmed ramp.</source>
            <translation>%1 µm is left, %2 µm is allowed: Z reaches only %3 rev/s² and cannot follow the programmed ramp.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: a resonance of Z bounds its gain.</source>
            <translation>%1 µm is left, %2 µm is allowed: a resonance of Z bounds its gain.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: all taps are used.</source>
            <translation>%1 µm is left, %2 µm is allowed: all taps are used.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: lag in Z bounds its gain.</source>
            <translation>%1 µm is left, %2 µm is allowed: lag in Z bounds its gain.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: the recorded signals are too noisy (%3 µm) to learn from.</source>
            <translation>%1 µm is left, %2 µm is allowed: the recorded signals are too noisy (%3 µm) to learn from.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: the slow tick of the position loop bounds the gain of Z.</source>
            <translation>%1 µm is left, %2 µm is allowed: the slow tick of the position loop bounds the gain of Z.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: the spindle reaches only %3 rev/s² and cannot follow the programmed ramp.</source>
            <translation>%1 µm is left, %2 µm is allowed: the spindle reaches only %3 rev/s² and cannot follow the programmed ramp.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: the trim of Z cannot take more.</source>
            <translation>%1 µm is left, %2 µm is allowed: the trim of Z cannot take more.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: this tuner changes the gain alone.</source>
            <translation>%1 µm is left, %2 µm is allowed: this tuner changes the gain alone.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: what is left differs from tap to tap.</source>
            <translation>%1 µm is left, %2 µm is allowed: what is left differs from tap to tap.</translation>
        </message>
        <message>
            <source>A faster velocity loop of Z, or a lower speed.</source>
            <translation>A faster velocity loop of Z, or a lower speed.</translation>
        </message>
        <message>
            <source>A filter at the resonance in the drive of Z, or a lower speed.</source>
            <translation>A filter at the resonance in the drive of Z, or a lower speed.</translation>
        </message>
        <message>
            <source>A lower gear, or a tap that needs less torque.</source>
            <translation>A lower gear, or a tap that needs less torque.</translation>
        </message>
        <message>
            <source>A lower speed, an even load, or a sharp tap.</source>
            <translation>A lower speed, an even load, or a sharp tap.</translation>
        </message>
        <message>
            <source>A lower speed, or a control that takes a trim of the Z command.</source>
            <translation>A lower speed, or a control that takes a trim of the Z command.</translation>
        </message>
        <message>
            <source>A shorter tick of the control's position loop, or a lower speed.</source>
            <translation>A shorter tick of the control's position loop, or a lower speed.</translation>
        </message>
        <message>
            <source>Finer encoders, or a filter on the recorded positions.</source>
            <translation>Finer encoders, or a filter on the recorded positions.</translation>
        </message>
        <message>
            <source>Program a ramp of %1 rev/s², then tune again: %2 s per hole instead of %3 s.</source>
            <translation>Program a ramp of %1 rev/s², then tune again: %2 s per hole instead of %3 s.</translation>
        </message>
        <message>
            <source>The default tuner, which learns feed-forward and trim too.</source>
            <translation>The default tuner, which learns feed-forward and trim too.</translation>
        </message>
        <message>
            <source>Tune again from here: it goes on with what it has learned.</source>
            <translation>Tune again from here: it goes on with what it has learned.</translation>
        </message>
        <message>
            <source>%1 cannot be written.</source>
            <translation>%1 cannot be written.</translation>
        </message>
        <message>
            <source>A Q-DAS file was not written</source>
            <translation>A Q-DAS file was not written</translation>
        </message>
        <message>
            <source>A file name may hold {type}, {lot}, {part}, {serial}, {machine}, {date} and {time}, and no folder.</source>
            <translation>A file name may hold {type}, {lot}, {part}, {serial}, {machine}, {date} and {time}, and no folder.</translation>
        </message>
        <message>
            <source>A gauge is overdue</source>
            <translation>A gauge is overdue</translation>
        </message>
        <message>
            <source>A part is out of tolerance</source>
            <translation>A part is out of tolerance</translation>
        </message>
        <message>
            <source>Gauge %1</source>
            <translation>Gauge %1</translation>
        </message>
        <message>
            <source>Have it checked, and enter the new date on the Quality page under Gauges.</source>
            <translation>Have it checked, and enter the new date on the Quality page under Gauges.</translation>
        </message>
        <message>
            <source>In control: the figures of the parts spread by chance.</source>
            <translation>In control: the figures of the parts spread by chance.</translation>
        </message>
        <message>
            <source>In control: the law predicts the parts. The last signal was %1 at part %2.</source>
            <translation>In control: the law predicts the parts. The last signal was %1 at part %2.</translation>
        </message>
        <message>
            <source>Its readings are taken as before, but nobody vouches for them.</source>
            <translation>Its readings are taken as before, but nobody vouches for them.</translation>
        </message>
        <message>
            <source>Look at tool, blank and gauge of that part. Announce a change on the Boring page.</source>
            <translation>Look at tool, blank and gauge of that part. Announce a change on the Boring page.</translation>
        </message>
        <message>
            <source>Make the folder reachable. The file is tried again with the next part.</source>
            <translation>Make the folder reachable. The file is tried again with the next part.</translation>
        </message>
        <message>
            <source>Measure it again. Set the part aside and say on the Quality page what was done with it.</source>
            <translation>Measure it again. Set the part aside and say on the Quality page what was done with it.</translation>
        </message>
        <message>
            <source>Part %1 can be cut again.</source>
            <translation>Part %1 can be cut again.</translation>
        </message>
        <message>
            <source>Part %1 is scrap.</source>
            <translation>Part %1 is scrap.</translation>
        </message>
        <message>
            <source>Part %1: %2.</source>
            <translation>Part %1: %2.</translation>
        </message>
        <message>
            <source>Parts may leave the tolerance sooner than the loop can follow. No capability is claimed.</source>
            <translation>Parts may leave the tolerance sooner than the loop can follow. No capability is claimed.</translation>
        </message>
        <message>
            <source>Something has changed that the law does not know: insert, material, clamping, gauge.</source>
            <translation>Something has changed that the law does not know: insert, material, clamping, gauge.</translation>
        </message>
        <message>
            <source>The date until which it was checked has passed.</source>
            <translation>The date until which it was checked has passed.</translation>
        </message>
        <message>
            <source>The file name must hold {part} or {serial}: each part has a file of its own.</source>
            <translation>The file name must hold {part} or {serial}: each part has a file of its own.</translation>
        </message>
        <message>
            <source>The folder is not there, is full, or may not be written to.</source>
            <translation>The folder is not there, is full, or may not be written to.</translation>
        </message>
        <message>
            <source>The law no longer predicts the parts</source>
            <translation>The law no longer predicts the parts</translation>
        </message>
        <message>
            <source>The lot has no parts yet.</source>
            <translation>The lot has no parts yet.</translation>
        </message>
        <message>
            <source>The part waits for a decision. The loop goes on and learns from the value.</source>
            <translation>The part waits for a decision. The loop goes on and learns from the value.</translation>
        </message>
        <message>
            <source>The values are stored here; the system that reads the folder does not have them.</source>
            <translation>The values are stored here; the system that reads the folder does not have them.</translation>
        </message>
        <message>
            <source>Tool, blank, clamping or gauge: the charts of the Quality page say whether it stands alone.</source>
            <translation>Tool, blank, clamping or gauge: the charts of the Quality page say whether it stands alone.</translation>
        </message>
        <message>
            <source>%1 has the drift of other axes than %2; train with days of the same axes.</source>
            <translation>%1 has the drift of other axes than %2; train with days of the same axes.</translation>
        </message>
        <message>
            <source>A hierarchical model needs at least two days; train a network, or record another day.</source>
            <translation>A hierarchical model needs at least two days; train a network, or record another day.</translation>
        </message>
        <message>
            <source>no measured drift; training needs at least one of yx_meas, yy_meas and yz_meas.</source>
            <translation>no measured drift; training needs at least one of yx_meas, yy_meas and yz_meas.</translation>
        </message>
        <message>
            <source>accepted under concession</source>
            <translation>accepted under concession</translation>
        </message>
        <message>
            <source>reworked</source>
            <translation>reworked</translation>
        </message>
        <message>
            <source>scrapped</source>
            <translation>scrapped</translation>
        </message>
        <message>
            <source>Setting ring of a comparator (0: it shows diameters)</source>
            <translation>Setting ring of a comparator (0: it shows diameters)</translation>
        </message>
        <message>
            <source>The samples are %1 s apart, at most %2 s are expected: is the time in ms?</source>
            <translation>The samples are %1 s apart, at most %2 s are expected: is the time in ms?</translation>
        </message>
        <message>
            <source>Measure the origin every hour; record this state and train again.</source>
            <translation>Measure the origin every hour; record this state and train again.</translation>
        </message>
        <message>
            <source>The interval is wider; the model learns from every measurement.</source>
            <translation>The interval is wider; the model learns from every measurement.</translation>
        </message>
        <message>
            <source>The measurements of today fit a machine that behaves otherwise.</source>
            <translation>The measurements of today fit a machine that behaves otherwise.</translation>
        </message>
        <message>
            <source>The model has learnt from this measurement already.</source>
            <translation>The model has learnt from this measurement already.</translation>
        </message>
        <message>
            <source>Today differs from the days trained on: measure</source>
            <translation>Today differs from the days trained on: measure</translation>
        </message>
        <message>
            <source>Today differs from the days trained on: measure.</source>
            <translation>Today differs from the days trained on: measure.</translation>
        </message>
        <message>
            <source>14 alternating</source>
            <translation>14 alternating</translation>
        </message>
        <message>
            <source>6 rising or falling</source>
            <translation>6 rising or falling</translation>
        </message>
        <message>
            <source>There is no such tool.</source>
            <translation>There is no such tool.</translation>
        </message>
        <message>
            <source>lasting error (CUSUM)</source>
            <translation>lasting error (CUSUM)</translation>
        </message>
        <message>
            <source>lasting error (EWMA)</source>
            <translation>lasting error (EWMA)</translation>
        </message>
        <message>
            <source>No stored tuning of this job is left out.</source>
            <translation>No stored tuning of this job is left out.</translation>
        </message>
        <message>
            <source>This job began from no stored tuning.</source>
            <translation>This job began from no stored tuning.</translation>
        </message>
        <message>
            <source>angle_rev means %1 rpm; at least %2 rpm are expected: is the time in ms?</source>
            <translation>angle_rev means %1 rpm; at least %2 rpm are expected: is the time in ms?</translation>
        </message>
        <message>
            <source>A tool comes to the end of its life</source>
            <translation>A tool comes to the end of its life</translation>
        </message>
        <message>
            <source>Cutting force unknown: control would go no faster than planned.</source>
            <translation>Cutting force unknown: control would go no faster than planned.</translation>
        </message>
        <message>
            <source>Feed really made is unknown: control would go no faster than planned.</source>
            <translation>Feed really made is unknown: control would go no faster than planned.</translation>
        </message>
        <message>
            <source>Have the next tool ready. After the change touch the strip under the header, and New tool.</source>
            <translation>Have the next tool ready. After the change touch the strip under the header, and New tool.</translation>
        </message>
        <message>
            <source>In air: control would take the entry feed until the tool meets the work.</source>
            <translation>In air: control would take the entry feed until the tool meets the work.</translation>
        </message>
        <message>
            <source>It has made nine tenths of the parts that were set for it, or more.</source>
            <translation>It has made nine tenths of the parts that were set for it, or more.</translation>
        </message>
        <message>
            <source>Nothing is stopped. Wear beyond its life changes the parts, and the loop has to follow it.</source>
            <translation>Nothing is stopped. Wear beyond its life changes the parts, and the loop has to follow it.</translation>
        </message>
        <message>
            <source>Outside the training range: the shift would fade to hold. Measure the origin.</source>
            <translation>Outside the training range: the shift would fade to hold. Measure the origin.</translation>
        </message>
        <message>
            <source>Programmed feed unknown: control would go no faster than the schedule's lowest feed.</source>
            <translation>Programmed feed unknown: control would go no faster than the schedule's lowest feed.</translation>
        </message>
        <message>
            <source>Ready: force feedback would begin at the touch of the next part.</source>
            <translation>Ready: force feedback would begin at the touch of the next part.</translation>
        </message>
        <message>
            <source>Spindle overhang unknown: control would go no faster than the schedule's lowest feed.</source>
            <translation>Spindle overhang unknown: control would go no faster than the schedule's lowest feed.</translation>
        </message>
        <message>
            <source>Spindle speed unknown or zero: control would go no faster than the schedule's lowest feed.</source>
            <translation>Spindle speed unknown or zero: control would go no faster than the schedule's lowest feed.</translation>
        </message>
        <message>
            <source>The best feed lies outside %1 to %2 mm/rev: the feed would sit at the limit.</source>
            <translation>The best feed lies outside %1 to %2 mm/rev: the feed would sit at the limit.</translation>
        </message>
        <message>
            <source>The feed stands; control would go on with it.</source>
            <translation>The feed stands; control would go on with it.</translation>
        </message>
        <message>
            <source>The feed would follow the schedule along the bore.</source>
            <translation>The feed would follow the schedule along the bore.</translation>
        </message>
        <message>
            <source>The feed would hold the reference force.</source>
            <translation>The feed would hold the reference force.</translation>
        </message>
        <message>
            <source>The insert of the boring bar has made %1 of %2 parts.</source>
            <translation>The insert of the boring bar has made %1 of %2 parts.</translation>
        </message>
        <message>
            <source>The milling tool has made %1 of %2 parts.</source>
            <translation>The milling tool has made %1 of %2 parts.</translation>
        </message>
        <message>
            <source>The reference force would need a feed outside %1 to %2 mm/s.</source>
            <translation>The reference force would need a feed outside %1 to %2 mm/s.</translation>
        </message>
        <message>
            <source>The shift would sit at its limit of size or rate.</source>
            <translation>The shift would sit at its limit of size or rate.</translation>
        </message>
        <message>
            <source>The tap has cut %1 of %2 threads.</source>
            <translation>The tap has cut %1 of %2 threads.</translation>
        </message>
        <message>
            <source>The trim would cancel %1 tones of the disturbance.</source>
            <translation>The trim would cancel %1 tones of the disturbance.</translation>
        </message>
        <message>
            <source>The trim would follow the depth error.</source>
            <translation>The trim would follow the depth error.</translation>
        </message>
        <message>
            <source>The trim would follow what can be foreseen of the disturbance.</source>
            <translation>The trim would follow what can be foreseen of the disturbance.</translation>
        </message>
        <message>
            <source>The turning tool has made %1 of %2 parts.</source>
            <translation>The turning tool has made %1 of %2 parts.</translation>
        </message>
        <message>
            <source>The work origin would follow the predicted drift.</source>
            <translation>The work origin would follow the predicted drift.</translation>
        </message>
        <message>
            <source>A command was not carried out</source>
            <translation>A command was not carried out</translation>
        </message>
        <message>
            <source>Accept a feed schedule</source>
            <translation>Accept a feed schedule</translation>
        </message>
        <message>
            <source>Add a part type for boring</source>
            <translation>Add a part type for boring</translation>
        </message>
        <message>
            <source>Announce a change of tool or material</source>
            <translation>Announce a change of tool or material</translation>
        </message>
        <message>
            <source>Change a boring recipe</source>
            <translation>Change a boring recipe</translation>
        </message>
        <message>
            <source>Change law or reference of milling</source>
            <translation>Change law or reference of milling</translation>
        </message>
        <message>
            <source>Change the blank profile</source>
            <translation>Change the blank profile</translation>
        </message>
        <message>
            <source>Change the law of turning</source>
            <translation>Change the law of turning</translation>
        </message>
        <message>
            <source>Change the limits of the thermal shift</source>
            <translation>Change the limits of the thermal shift</translation>
        </message>
        <message>
            <source>Change the milling setup</source>
            <translation>Change the milling setup</translation>
        </message>
        <message>
            <source>Change the turning setup</source>
            <translation>Change the turning setup</translation>
        </message>
        <message>
            <source>Choose a milled part type</source>
            <translation>Choose a milled part type</translation>
        </message>
        <message>
            <source>Close a lot or leave it out of memory</source>
            <translation>Close a lot or leave it out of memory</translation>
        </message>
        <message>
            <source>Close the port in the firewall and give it passwords of your own: see the LinuxCNC guide, "Close the port". Then start the console anew.</source>
            <translation>Close the port in the firewall and give it passwords of your own: see the LinuxCNC guide, "Close the port". Then start the console anew.</translation>
        </message>
        <message>
            <source>Correct or void a diameter</source>
            <translation>Correct or void a diameter</translation>
        </message>
        <message>
            <source>Enter a diameter</source>
            <translation>Enter a diameter</translation>
        </message>
        <message>
            <source>Give a reason: it is kept with the change.</source>
            <translation>Give a reason: it is kept with the change.</translation>
        </message>
        <message>
            <source>It answers on %1.</source>
            <translation>It answers on %1.</translation>
        </message>
        <message>
            <source>Leave a milling tool out of memory</source>
            <translation>Leave a milling tool out of memory</translation>
        </message>
        <message>
            <source>Leave a stored tuning out</source>
            <translation>Leave a stored tuning out</translation>
        </message>
        <message>
            <source>Load a tapping job</source>
            <translation>Load a tapping job</translation>
        </message>
        <message>
            <source>Network, server or sign-on: the Diagnostics page says what it answered last.</source>
            <translation>Network, server or sign-on: the Diagnostics page says what it answered last.</translation>
        </message>
        <message>
            <source>Nothing is lost: parts and values wait here and travel when it answers again.</source>
            <translation>Nothing is lost: parts and values wait here and travel when it answers again.</translation>
        </message>
        <message>
            <source>Nothing to do at the machine. Tell whoever looks after the server when it stays.</source>
            <translation>Nothing to do at the machine. Tell whoever looks after the server when it stays.</translation>
        </message>
        <message>
            <source>Open or choose a lot</source>
            <translation>Open or choose a lot</translation>
        </message>
        <message>
            <source>Overhangs from %1 to %2 mm lie beyond what Z reaches by the machine file.</source>
            <translation>Overhangs from %1 to %2 mm lie beyond what Z reaches by the machine file.</translation>
        </message>
        <message>
            <source>Place a sensor on the picture</source>
            <translation>Place a sensor on the picture</translation>
        </message>
        <message>
            <source>Put a thermal model live or back</source>
            <translation>Put a thermal model live or back</translation>
        </message>
        <message>
            <source>Raise a limit of milling</source>
            <translation>Raise a limit of milling</translation>
        </message>
        <message>
            <source>Raise a limit of turning</source>
            <translation>Raise a limit of turning</translation>
        </message>
        <message>
            <source>Read the reason beside it, look at the control's own message, put it right and ask again.</source>
            <translation>Read the reason beside it, look at the control's own message, put it right and ask again.</translation>
        </message>
        <message>
            <source>Record a gap-sensor session</source>
            <translation>Record a gap-sensor session</translation>
        </message>
        <message>
            <source>Release a stop</source>
            <translation>Release a stop</translation>
        </message>
        <message>
            <source>Say that a new milling tool is in</source>
            <translation>Say that a new milling tool is in</translation>
        </message>
        <message>
            <source>Switch a loop</source>
            <translation>Switch a loop</translation>
        </message>
        <message>
            <source>Take a reference or a measurement of the origin over</source>
            <translation>Take a reference or a measurement of the origin over</translation>
        </message>
        <message>
            <source>The control or a rule of Kerf's has refused it, or nothing came of it.</source>
            <translation>The control or a rule of Kerf's has refused it, or nothing came of it.</translation>
        </message>
        <message>
            <source>The control's command port is open to the network</source>
            <translation>The control's command port is open to the network</translation>
        </message>
        <message>
            <source>The machine file does not name this process under hosts.</source>
            <translation>The machine file does not name this process under hosts.</translation>
        </message>
        <message>
            <source>The program is %1 mm long; the machine file gives this axis %2 mm.</source>
            <translation>The program is %1 mm long; the machine file gives this axis %2 mm.</translation>
        </message>
        <message>
            <source>The program wants %1 rpm; the machine file allows the spindle %2 rpm.</source>
            <translation>The program wants %1 rpm; the machine file allows the spindle %2 rpm.</translation>
        </message>
        <message>
            <source>The shop's store is out of reach</source>
            <translation>The shop's store is out of reach</translation>
        </message>
        <message>
            <source>Tune, accept a tuning or roll it back</source>
            <translation>Tune, accept a tuning or roll it back</translation>
        </message>
        <message>
            <source>What was asked for has not happened. The machine stands as it stood before.</source>
            <translation>What was asked for has not happened. The machine stands as it stood before.</translation>
        </message>
        <message>
            <source>Whoever reaches this computer may move the machine.</source>
            <translation>Whoever reaches this computer may move the machine.</translation>
        </message>
        <message>
            <source>linuxcncrsh answers on an address that other computers reach, with passwords that everybody knows.</source>
            <translation>linuxcncrsh answers on an address that other computers reach, with passwords that everybody knows.</translation>
        </message>
        <message>
            <source>units: the machine file says %1, [TRAJ]LINEAR_UNITS of the control says %2. Nothing is commanded before they agree.</source>
            <translation>units: the machine file says %1, [TRAJ]LINEAR_UNITS of the control says %2. Nothing is commanded before they agree.</translation>
        </message>
        <message>
            <source>Reason of a stop, note or handover of a shift</source>
            <translation>Reason of a stop, note or handover of a shift</translation>
        </message>
        <message>
            <source>Say that a new tool is in</source>
            <translation>Say that a new tool is in</translation>
        </message>
        <message>
            <source>Set the life of a tool</source>
            <translation>Set the life of a tool</translation>
        </message>
        <message>
            <source>A backup has taken the place of the data; what was there is kept as %1.</source>
            <translation>A backup has taken the place of the data; what was there is kept as %1.</translation>
        </message>
        <message>
            <source>A backup lies ready, but not who has asked for it: delete kerf.db.restore or ask again.</source>
            <translation>A backup lies ready, but not who has asked for it: delete kerf.db.restore or ask again.</translation>
        </message>
        <message>
            <source>Nobody takes himself off the list: somebody else has to.</source>
            <translation>Nobody takes himself off the list: somebody else has to.</translation>
        </message>
        <message>
            <source>Put a backup in the place of the data</source>
            <translation>Put a backup in the place of the data</translation>
        </message>
        <message>
            <source>Take somebody off the list of people</source>
            <translation>Take somebody off the list of people</translation>
        </message>
        <message>
            <source>The backup could not be put in place: check the folder and its permissions.</source>
            <translation>The backup could not be put in place: check the folder and its permissions.</translation>
        </message>
        <message>
            <source>There is no such file.</source>
            <translation>There is no such file.</translation>
        </message>
        <message>
            <source>There is no such person on the list.</source>
            <translation>There is no such person on the list.</translation>
        </message>
        <message>
            <source>This backup is of a later version of Kerf.</source>
            <translation>This backup is of a later version of Kerf.</translation>
        </message>
        <message>
            <source>This is no data file of Kerf's.</source>
            <translation>This is no data file of Kerf's.</translation>
        </message>
        <message>
            <source>Change the spindle speed by 5 to 15 %, take less depth, or clamp tool and work shorter.</source>
            <translation>Change the spindle speed by 5 to 15 %, take less depth, or clamp tool and work shorter.</translation>
        </message>
        <message>
            <source>Chatter</source>
            <translation>Chatter</translation>
        </message>
        <message>
            <source>The force swings at a frequency that is no multiple of the spindle's: at this depth and speed the cut excites tool and work.</source>
            <translation>The force swings at a frequency that is no multiple of the spindle's: at this depth and speed the cut excites tool and work.</translation>
        </message>
        <message>
            <source>The force swings by %1 N at about %2 Hz.</source>
            <translation>The force swings by %1 N at about %2 Hz.</translation>
        </message>
        <message>
            <source>The wall gets marks, the tool wears fast and may break. The feed goes on holding the mean force: it does not cure chatter.</source>
            <translation>The wall gets marks, the tool wears fast and may break. The feed goes on holding the mean force: it does not cure chatter.</translation>
        </message>
        <message>
            <source>Raise a limit by more than half, with a second person</source>
            <translation>Raise a limit by more than half, with a second person</translation>
        </message>
        <message>
            <source>Raising a limit by more than half takes two: another setter or process engineer says yes first (touch the name in the header, Second person).</source>
            <translation>Raising a limit by more than half takes two: another setter or process engineer says yes first (touch the name in the header, Second person).</translation>
        </message>
        <message>
            <source>A deviation of more than 200 µm is no thermal drift: look at the part.</source>
            <translation>A deviation of more than 200 µm is no thermal drift: look at the part.</translation>
        </message>
        <message>
            <source>A part is being cut: the shift waits for its end.</source>
            <translation>A part is being cut: the shift waits for its end.</translation>
        </message>
        <message>
            <source>Diameter (X), measured − nominal</source>
            <translation>Diameter (X), measured − nominal</translation>
        </message>
        <message>
            <source>Length (Z), measured − nominal</source>
            <translation>Length (Z), measured − nominal</translation>
        </message>
        <message>
            <source>No part has been finished since the reference that has not been measured yet.</source>
            <translation>No part has been finished since the reference that has not been measured yet.</translation>
        </message>
        <message>
            <source>Nothing of the part has been measured.</source>
            <translation>Nothing of the part has been measured.</translation>
        </message>
        <message>
            <source>The model has changed since that part was cut: measure the next one.</source>
            <translation>The model has changed since that part was cut: measure the next one.</translation>
        </message>
        <message>
            <source>Y, measured − nominal</source>
            <translation>Y, measured − nominal</translation>
        </message>
        <message>
            <source>At %1 rpm this force signal brings %2 values per revolution; 8 are needed.</source>
            <translation>At %1 rpm this force signal brings %2 values per revolution; 8 are needed.</translation>
        </message>
        <message>
            <source>Behind the last cut the sensor's zero was not where it was before.</source>
            <translation>Behind the last cut the sensor's zero was not where it was before.</translation>
        </message>
        <message>
            <source>Check cable and insulation of the sensor: moisture lets its charge leak.</source>
            <translation>Check cable and insulation of the sensor: moisture lets its charge leak.</translation>
        </message>
        <message>
            <source>Force feedback needs a force of %1 Hz bandwidth; this one has %2 Hz: no trim.</source>
            <translation>Force feedback needs a force of %1 Hz bandwidth; this one has %2 Hz: no trim.</translation>
        </message>
        <message>
            <source>In air: the zero of the force is taken.</source>
            <translation>In air: the zero of the force is taken.</translation>
        </message>
        <message>
            <source>It may be wrong by %1 N.</source>
            <translation>It may be wrong by %1 N.</translation>
        </message>
        <message>
            <source>Let the path begin in the air. If it comes back in a long cut: check the sensor's insulation, or divide the cut.</source>
            <translation>Let the path begin in the air. If it comes back in a long cut: check the sensor's insulation, or divide the cut.</translation>
        </message>
        <message>
            <source>Let the tool stand in the air before it touches. If it comes back in a long cut: check the sensor's insulation, or divide the cut.</source>
            <translation>Let the tool stand in the air before it touches. If it comes back in a long cut: check the sensor's insulation, or divide the cut.</translation>
        </message>
        <message>
            <source>The bandwidth of the force signal is not stated: set kerf.force-bandwidth, or force.bandwidth_hz in the machine file.</source>
            <translation>The bandwidth of the force signal is not stated: set kerf.force-bandwidth, or force.bandwidth_hz in the machine file.</translation>
        </message>
        <message>
            <source>The force counts as unknown: the feed stays, or falls to the planned feed if it was faster. Overload and breakage are not noticed.</source>
            <translation>The force counts as unknown: the feed stays, or falls to the planned feed if it was faster. Overload and breakage are not noticed.</translation>
        </message>
        <message>
            <source>The force of that cut was wrong by as much at its end. The next cut trusts the zero for a shorter time.</source>
            <translation>The force of that cut was wrong by as much at its end. The next cut trusts the zero for a shorter time.</translation>
        </message>
        <message>
            <source>The force sensor does not keep its zero, and it was not taken before this cut, or is too old for its drift.</source>
            <translation>The force sensor does not keep its zero, and it was not taken before this cut, or is too old for its drift.</translation>
        </message>
        <message>
            <source>The tool was not in the air for long enough before the cut.</source>
            <translation>The tool was not in the air for long enough before the cut.</translation>
        </message>
        <message>
            <source>The zero has moved by %1 N in the last cut.</source>
            <translation>The zero has moved by %1 N in the last cut.</translation>
        </message>
        <message>
            <source>The zero of the force has drifted</source>
            <translation>The zero of the force has drifted</translation>
        </message>
        <message>
            <source>The zero of the force may have drifted: no trim in the rest of this part.</source>
            <translation>The zero of the force may have drifted: no trim in the rest of this part.</translation>
        </message>
        <message>
            <source>There is no trim in this part, or in the rest of it.</source>
            <translation>There is no trim in this part, or in the rest of it.</translation>
        </message>
        <message>
            <source>Zero of the force unknown</source>
            <translation>Zero of the force unknown</translation>
        </message>
        <message>
            <source>kerf.force is linked, but sampler.0.pin.6 is not linked to the same signal: take kerf.hal of this version and kerf-force.hal.</source>
            <translation>kerf.force is linked, but sampler.0.pin.6 is not linked to the same signal: take kerf.hal of this version and kerf-force.hal.</translation>
        </message>
        <message>
            <source>kerf.force-reset is not linked: the amplifier is not reset by Kerf.</source>
            <translation>kerf.force-reset is not linked: the amplifier is not reset by Kerf.</translation>
        </message>
        <message>
            <source>A value from a file needs the file's name.</source>
            <translation>A value from a file needs the file's name.</translation>
        </message>
        <message>
            <source>Change the register of gauges</source>
            <translation>Change the register of gauges</translation>
        </message>
        <message>
            <source>Keep the study of a gauge</source>
            <translation>Keep the study of a gauge</translation>
        </message>
        <message>
            <source>Part %1 has %2 mm here already; correct that one instead.</source>
            <translation>Part %1 has %2 mm here already; correct that one instead.</translation>
        </message>
        <message>
            <source>Part %1 is not in this lot.</source>
            <translation>Part %1 is not in this lot.</translation>
        </message>
        <message>
            <source>Part %1 is not measured at %2 mm.</source>
            <translation>Part %1 is not measured at %2 mm.</translation>
        </message>
        <message>
            <source>Part %1 stands in the file twice, with %2 mm and %3 mm.</source>
            <translation>Part %1 stands in the file twice, with %2 mm and %3 mm.</translation>
        </message>
        <message>
            <source>Say what was done with a part out of tolerance</source>
            <translation>Say what was done with a part out of tolerance</translation>
        </message>
        <message>
            <source>Set the limits of figures</source>
            <translation>Set the limits of figures</translation>
        </message>
        <message>
            <source>Set where Q-DAS files appear</source>
            <translation>Set where Q-DAS files appear</translation>
        </message>
        <message>
            <source>The data file numbers its measurements with gaps.</source>
            <translation>The data file numbers its measurements with gaps.</translation>
        </message>
        <message>
            <source>The file holds no diameter that is not stored already.</source>
            <translation>The file holds no diameter that is not stored already.</translation>
        </message>
        <message>
            <source>The file says nowhere at which depth this is: a column overhang_mm is missing.</source>
            <translation>The file says nowhere at which depth this is: a column overhang_mm is missing.</translation>
        </message>
        <message>
            <source>This console takes no files of diameters.</source>
            <translation>This console takes no files of diameters.</translation>
        </message>
        <message>
            <source>%1 lots one after the other, %2 parts on the charts, %3 signals.</source>
            <translation>%1 lots one after the other, %2 parts on the charts, %3 signals.</translation>
        </message>
        <message>
            <source>Choose one lot: a report and its files are of one.</source>
            <translation>Choose one lot: a report and its files are of one.</translation>
        </message>
        <message>
            <source>The lots have no parts yet.</source>
            <translation>The lots have no parts yet.</translation>
        </message>
        <message>
            <source>kerf.loss-scale is not linked: a bridge that comes late would leave the highest feed. Take kerf.hal of this version.</source>
            <translation>kerf.loss-scale is not linked: a bridge that comes late would leave the highest feed. Take kerf.hal of this version.</translation>
        </message>
        <message>
            <source>Draw on other machines' lots in the shop (1 yes, 0 no)</source>
            <translation>Draw on other machines' lots in the shop (1 yes, 0 no)</translation>
        </message>
        <message>
            <source>Expected from %1 earlier lots and %2 of other machines; the bending of a new tool differs by ± %3 % (1σ).</source>
            <translation>Expected from %1 earlier lots and %2 of other machines; the bending of a new tool differs by ± %3 % (1σ).</translation>
        </message>
        <message>
            <source>Expected from this lot, %1 earlier ones and %2 of other machines; after such a change the bending differs by ± %3 % (1σ).</source>
            <translation>Expected from this lot, %1 earlier ones and %2 of other machines; after such a change the bending differs by ± %3 % (1σ).</translation>
        </message>
        <message>
            <source>The connection in shop/memory cannot be used (no password may stand there): this lot begins without other machines' lots.</source>
            <translation>The connection in shop/memory cannot be used (no password may stand there): this lot begins without other machines' lots.</translation>
        </message>
        <message>
            <source>The data folder names no shop to read (shop/memory): this lot begins without other machines' lots.</source>
            <translation>The data folder names no shop to read (shop/memory): this lot begins without other machines' lots.</translation>
        </message>
        <message>
            <source>The shop answered after the first part had begun: this lot begins without other machines' lots.</source>
            <translation>The shop answered after the first part had begun: this lot begins without other machines' lots.</translation>
        </message>
        <message>
            <source>The shop does not let this console read: this lot begins without other machines' lots.</source>
            <translation>The shop does not let this console read: this lot begins without other machines' lots.</translation>
        </message>
        <message>
            <source>The shop has no lots of this part type on other machines.</source>
            <translation>The shop has no lots of this part type on other machines.</translation>
        </message>
        <message>
            <source>The shop is asked for lots of other machines.</source>
            <translation>The shop is asked for lots of other machines.</translation>
        </message>
        <message>
            <source>The shop is out of reach: this lot begins without other machines' lots.</source>
            <translation>The shop is out of reach: this lot begins without other machines' lots.</translation>
        </message>
        <message>
            <source>There is no shop in the database: this lot begins without other machines' lots.</source>
            <translation>There is no shop in the database: this lot begins without other machines' lots.</translation>
        </message>
        <message>
            <source>Boring</source>
            <translation>Boring</translation>
        </message>
        <message>
            <source>Change the set-up of a process</source>
            <translation>Change the set-up of a process</translation>
        </message>
        <message>
            <source>Kerf does not know this process on a LinuxCNC.</source>
            <translation>Kerf does not know this process on a LinuxCNC.</translation>
        </message>
        <message>
            <source>Milling</source>
            <translation>Milling</translation>
        </message>
        <message>
            <source>Tapping</source>
            <translation>Tapping</translation>
        </message>
        <message>
            <source>The tool has made %1 of %2 parts.</source>
            <translation>The tool has made %1 of %2 parts.</translation>
        </message>
        <message>
            <source>Thermal</source>
            <translation>Thermal</translation>
        </message>
        <message>
            <source>Turning</source>
            <translation>Turning</translation>
        </message>
        <message>
            <source>Nobody commands this machine: the program that did has ended. This one only reads; end it and start it anew, then it commands.</source>
            <translation>Nobody commands this machine: the program that did has ended. This one only reads; end it and start it anew, then it commands.</translation>
        </message>
        <message>
            <source>The log file (-wal) beside the data file was deleted, moved or replaced while Kerf runs: nothing more is stored. End Kerf and start it anew; what waits is kept beside it.</source>
            <translation>The log file (-wal) beside the data file was deleted, moved or replaced while Kerf runs: nothing more is stored. End Kerf and start it anew; what waits is kept beside it.</translation>
        </message>
        <message>
            <source>full</source>
            <translation>full</translation>
        </message>
        <message>
            <source>kept by a version that noted no hash</source>
            <translation>kept by a version that noted no hash</translation>
        </message>
        <message>
            <source>part type created</source>
            <translation>part type created</translation>
        </message>
        <message>
            <source>repeatability of gauge %1, study %2</source>
            <translation>repeatability of gauge %1, study %2</translation>
        </message>
        <message>
            <source>setup changed</source>
            <translation>setup changed</translation>
        </message>
        <message>
            <source>%1 revisions of the recipe of %2 were saved, %3 are stored.</source>
            <translation>%1 revisions of the recipe of %2 were saved, %3 are stored.</translation>
        </message>
        <message>
            <source>Nothing is stored here.</source>
            <translation>Nothing is stored here.</translation>
        </message>
        <message>
            <source>This recipe revision is of another version, or cannot be used.</source>
            <translation>This recipe revision is of another version, or cannot be used.</translation>
        </message>
        <message>
            <source>This revision leaves a tuning out or takes it in; it has no settings of its own.</source>
            <translation>This revision leaves a tuning out or takes it in; it has no settings of its own.</translation>
        </message>
        <message>
            <source>The backup %1 cannot be written: its folder is missing or read-only.</source>
            <translation>The backup %1 cannot be written: its folder is missing or read-only.</translation>
        </message>
        <message>
            <source>Samples of the force are missing: no trim in the rest of this part.</source>
            <translation>Samples of the force are missing: no trim in the rest of this part.</translation>
        </message>
        <message>
            <source>The key %1 stands twice in one object; it is expected once.</source>
            <translation>The key %1 stands twice in one object; it is expected once.</translation>
        </message>
        <message>
            <source>The position of the boring spindle is missing, old, not a number, or stands still while it feeds.</source>
            <translation>The position of the boring spindle is missing, old, not a number, or stands still while it feeds.</translation>
        </message>
        <message>
            <source>There is no part type yet whose recipe could hold limits.</source>
            <translation>There is no part type yet whose recipe could hold limits.</translation>
        </message>
        <message>
            <source>%1 lots were opened, %2 are stored.</source>
            <translation>%1 lots were opened, %2 are stored.</translation>
        </message>
        <message>
            <source>A lot needs a name.</source>
            <translation>A lot needs a name.</translation>
        </message>
        <message>
            <source>Lot %1 (%2) differs from what was logged when it was opened or closed.</source>
            <translation>Lot %1 (%2) differs from what was logged when it was opened or closed.</translation>
        </message>
        <message>
            <source>Lot, recipe or schedule has changed since the start was asked: look, then start again.</source>
            <translation>Lot, recipe or schedule has changed since the start was asked: look, then start again.</translation>
        </message>
        <message>
            <source>No lot is open.</source>
            <translation>No lot is open.</translation>
        </message>
        <message>
            <source>Part %1 differs from what was kept of it when it was made, or one before it is missing.</source>
            <translation>Part %1 differs from what was kept of it when it was made, or one before it is missing.</translation>
        </message>
        <message>
            <source>The part type has changed: nothing was opened.</source>
            <translation>The part type has changed: nothing was opened.</translation>
        </message>
        <message>
            <source>There is a lot of this name already.</source>
            <translation>There is a lot of this name already.</translation>
        </message>
        <message>
            <source>This lot is of %1: choose that part type first.</source>
            <translation>This lot is of %1: choose that part type first.</translation>
        </message>
        <message>
            <source>lot selected</source>
            <translation>lot selected</translation>
        </message>
        <message>
            <source>The log file (kerf.log) cannot be written: check the data folder and its permissions.</source>
            <translation>The log file (kerf.log) cannot be written: check the data folder and its permissions.</translation>
        </message>
        <message>
            <source>The name of the data folder is not UTF-8: rename it, or choose another one with --data.</source>
            <translation>The name of the data folder is not UTF-8: rename it, or choose another one with --data.</translation>
        </message>
        <message>
            <source>Acceleration feed-forward of Z</source>
            <translation>Acceleration feed-forward of Z</translation>
        </message>
        <message>
            <source>Follow gain of Z</source>
            <translation>Follow gain of Z</translation>
        </message>
        <message>
            <source>Follow gain of the spindle</source>
            <translation>Follow gain of the spindle</translation>
        </message>
        <message>
            <source>Shift only between parts</source>
            <translation>Shift only between parts</translation>
        </message>
        <message>
            <source>Speed feed-forward of Z</source>
            <translation>Speed feed-forward of Z</translation>
        </message>
        <message>
            <source>Blank profile</source>
            <translation>Blank profile</translation>
        </message>
        <message>
            <source>Law</source>
            <translation>Law</translation>
        </message>
        <message>
            <source>blank profile of before</source>
            <translation>blank profile of before</translation>
        </message>
        <message>
            <source>changed while cutting</source>
            <translation>changed while cutting</translation>
        </message>
        <message>
            <source>law chosen</source>
            <translation>law chosen</translation>
        </message>
        <message>
            <source>law of before</source>
            <translation>law of before</translation>
        </message>
        <message>
            <source>typed</source>
            <translation>typed</translation>
        </message>
        <message>
            <source>A part is being cut: leave parts out between two of them.</source>
            <translation>A part is being cut: leave parts out between two of them.</translation>
        </message>
        <message>
            <source>Leave a turned part out of memory</source>
            <translation>Leave a turned part out of memory</translation>
        </message>
        <message>
            <source>Too little is known to be sure of the tolerance: the feed aims at %1 mm, from where both limits are equally far by the law.</source>
            <translation>Too little is known to be sure of the tolerance: the feed aims at %1 mm, from where both limits are equally far by the law.</translation>
        </message>
        <message>
            <source>One address is asked after the other.</source>
            <translation>One address is asked after the other.</translation>
        </message>
        <message>
            <source>That sensor file cannot be used.</source>
            <translation>That sensor file cannot be used.</translation>
        </message>
        <message>
            <source>The sensor file %1 cannot be used: only what the machine itself brings is read. Sensors says why.</source>
            <translation>The sensor file %1 cannot be used: only what the machine itself brings is read. Sensors says why.</translation>
        </message>
        <message>
            <source>Blank height</source>
            <translation>Blank height</translation>
        </message>
        <message>
            <source>Leave a day out of thermal training</source>
            <translation>Leave a day out of thermal training</translation>
        </message>
        <message>
            <source>One of the days is left out of the training: take it in again first.</source>
            <translation>One of the days is left out of the training: take it in again first.</translation>
        </message>
        <message>
            <source>%1 is neither; expected true or false.</source>
            <translation>%1 is neither; expected true or false.</translation>
        </message>
        <message>
            <source>%1 is no list; expected [ … ].</source>
            <translation>%1 is no list; expected [ … ].</translation>
        </message>
        <message>
            <source>%1 is no object; expected {…} with keys.</source>
            <translation>%1 is no object; expected {…} with keys.</translation>
        </message>
        <message>
            <source>the file: %1 is no object; expected {…} with keys.</source>
            <translation>the file: %1 is no object; expected {…} with keys.</translation>
        </message>
        <message>
            <source>%1 is no text; expected a text that is not empty.</source>
            <translation>%1 is no text; expected a text that is not empty.</translation>
        </message>
        <message>
            <source>%1 is no text; expected a text.</source>
            <translation>%1 is no text; expected a text.</translation>
        </message>
        <message>
            <source>%1 is out of range; expected a number from %2 to %3.</source>
            <translation>%1 is out of range; expected a number from %2 to %3.</translation>
        </message>
        <message>
            <source>%1 is out of range; expected a whole number from %2 to %3.</source>
            <translation>%1 is out of range; expected a whole number from %2 to %3.</translation>
        </message>
        <message>
            <source>%1 is the device of %2 too; expected one of its own (the channels of a multiplexer belong to one gauge).</source>
            <translation>%1 is the device of %2 too; expected one of its own (the channels of a multiplexer belong to one gauge).</translation>
        </message>
        <message>
            <source>%1 is the unit of modules[%2] on the same line; expected another one.</source>
            <translation>%1 is the unit of modules[%2] on the same line; expected another one.</translation>
        </message>
        <message>
            <source>%1 of them; expected %2 at the most.</source>
            <translation>%1 of them; expected %2 at the most.</translation>
        </message>
        <message>
            <source>%1 temperatures; expected %2 at the most.</source>
            <translation>%1 temperatures; expected %2 at the most.</translation>
        </message>
        <message>
            <source>'%1' is no name; expected 1 to %2 bytes without comma, quote or line end.</source>
            <translation>'%1' is no name; expected 1 to %2 bytes without comma, quote or line end.</translation>
        </message>
        <message>
            <source>'%1' is no pin of kerf-hal for this quantity; expected kerf.temperature-0 to kerf.temperature-%2 for a temperature.</source>
            <translation>'%1' is no pin of kerf-hal for this quantity; expected kerf.temperature-0 to kerf.temperature-%2 for a temperature.</translation>
        </message>
        <message>
            <source>'%1' is not known; expected one of %2.</source>
            <translation>'%1' is not known; expected one of %2.</translation>
        </message>
        <message>
            <source>'%1' is not the unit of a %2; expected %3, which scale and offset bring the register to.</source>
            <translation>'%1' is not the unit of a %2; expected %3, which scale and offset bring the register to.</translation>
        </message>
        <message>
            <source>'%1' is the name of %2 too; expected another one.</source>
            <translation>'%1' is the name of %2 too; expected another one.</translation>
        </message>
        <message>
            <source>'%1': it has no group; expected one around the value.</source>
            <translation>'%1': it has no group; expected one around the value.</translation>
        </message>
        <message>
            <source>'%1': it is no regular expression; expected one as ^.*?([+-][0-9.]+).*$.</source>
            <translation>'%1': it is no regular expression; expected one as ^.*?([+-][0-9.]+).*$.</translation>
        </message>
        <message>
            <source>0 makes every reading the same; expected a factor other than 0.</source>
            <translation>0 makes every reading the same; expected a factor other than 0.</translation>
        </message>
        <message>
            <source>a force is too fast for a polled module; it comes over the HAL pin kerf.force (docs/sensors.md). Expected temperature or speed.</source>
            <translation>a force is too fast for a polled module; it comes over the HAL pin kerf.force (docs/sensors.md). Expected temperature or speed.</translation>
        </message>
        <message>
            <source>the file: a number is too large to be stored; expected a sensor file.</source>
            <translation>the file: a number is too large to be stored; expected a sensor file.</translation>
        </message>
        <message>
            <source>a second speed; expected one at the most.</source>
            <translation>a second speed; expected one at the most.</translation>
        </message>
        <message>
            <source>cannot be read, or is empty; expected a sensor file.</source>
            <translation>cannot be read, or is empty; expected a sensor file.</translation>
        </message>
        <message>
            <source>it could not be asked; the log says why.</source>
            <translation>it could not be asked; the log says why.</translation>
        </message>
        <message>
            <source>larger than %1 MB; expected a sensor file.</source>
            <translation>larger than %1 MB; expected a sensor file.</translation>
        </message>
        <message>
            <source>missing; expected a regular expression whose first group is the value.</source>
            <translation>missing; expected a regular expression whose first group is the value.</translation>
        </message>
        <message>
            <source>missing; expected a value.</source>
            <translation>missing; expected a value.</translation>
        </message>
        <message>
            <source>modules[%1] is on the same line %2 with other settings; expected the same baud, parity and stop_bits.</source>
            <translation>modules[%1] is on the same line %2 with other settings; expected the same baud, parity and stop_bits.</translation>
        </message>
        <message>
            <source>the file: more than %1 brackets inside each other; expected a sensor file.</source>
            <translation>the file: more than %1 brackets inside each other; expected a sensor file.</translation>
        </message>
        <message>
            <source>the file: more than %1 keys in one object; expected a sensor file.</source>
            <translation>the file: more than %1 keys in one object; expected a sensor file.</translation>
        </message>
        <message>
            <source>no value in it; expected at least one that means a fault.</source>
            <translation>no value in it; expected at least one that means a fault.</translation>
        </message>
        <message>
            <source>none; expected at least one channel or gauge.</source>
            <translation>none; expected at least one channel or gauge.</translation>
        </message>
        <message>
            <source>not an object; expected {"channel": depth, …}.</source>
            <translation>not an object; expected {"channel": depth, …}.</translation>
        </message>
        <message>
            <source>only for the protocol pattern; expected no such key here.</source>
            <translation>only for the protocol pattern; expected no such key here.</translation>
        </message>
        <message>
            <source>that is no address; expected HOST or HOST:PORT, PORT from 1 to 65535.</source>
            <translation>that is no address; expected HOST or HOST:PORT, PORT from 1 to 65535.</translation>
        </message>
        <message>
            <source>the key stands twice in one object; expected it once.</source>
            <translation>the key stands twice in one object; expected it once.</translation>
        </message>
        <message>
            <source>there is no module '%1'; expected the name of one in modules.</source>
            <translation>there is no module '%1'; expected the name of one in modules.</translation>
        </message>
        <message>
            <source>line %1, column %2: this is no JSON from here on; expected a complete JSON object.</source>
            <translation>line %1, column %2: this is no JSON from here on; expected a complete JSON object.</translation>
        </message>
        <message>
            <source>unknown key %2; expected one of %1.</source>
            <translation>unknown key %2; expected one of %1.</translation>
        </message>
        <message>
            <source>accepted</source>
            <translation>accepted</translation>
        </message>
        <message>
            <source>rolled back</source>
            <translation>rolled back</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ActionChart</name>
        <message>
            <source>part</source>
            <translation>part</translation>
        </message>
        <message>
            <source>feed in the middle of the bore</source>
            <translation>feed in the middle of the bore</translation>
        </message>
        <message>
            <source>What the controller does from part to part appears here.</source>
            <translation>What the controller does from part to part appears here.</translation>
        </message>
        <message>
            <source>Control action</source>
            <translation>Control action</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::AlarmBar</name>
        <message>
            <source>No alarms.</source>
            <translation>No alarms.</translation>
        </message>
        <message numerus="yes">
            <source>%1  (and %n more)</source>
            <translation>
                <numerusform>%1  (and %n more)</numerusform>
                <numerusform>%1  (and %n more)</numerusform>
            </translation>
        </message>
        <message>
            <source>Show</source>
            <translation>Show</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::AlarmModel</name>
        <message>
            <source>stands, seen by %1</source>
            <translation>stands, seen by %1</translation>
        </message>
        <message>
            <source>stands</source>
            <translation>stands</translation>
        </message>
        <message>
            <source>stood at the last restart</source>
            <translation>stood at the last restart</translation>
        </message>
        <message>
            <source>gone %1, seen by %2</source>
            <translation>gone %1, seen by %2</translation>
        </message>
        <message>
            <source>gone %1</source>
            <translation>gone %1</translation>
        </message>
        <message>
            <source>%1, first</source>
            <translation>%1, first</translation>
        </message>
        <message>
            <source>Prio.</source>
            <translation>Prio.</translation>
        </message>
        <message>
            <source>Alarm</source>
            <translation>Alarm</translation>
        </message>
        <message>
            <source>Since</source>
            <translation>Since</translation>
        </message>
        <message>
            <source>State</source>
            <translation>State</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::AlarmsPage</name>
        <message>
            <source>That is all.</source>
            <translation>That is all.</translation>
        </message>
        <message>
            <source>No database is connected: only the alarms since the start are known.</source>
            <translation>No database is connected: only the alarms since the start are known.</translation>
        </message>
        <message>
            <source>No alarm has been recorded yet.</source>
            <translation>No alarm has been recorded yet.</translation>
        </message>
        <message>
            <source>No alarms stand. One that comes up appears here until it has gone and been seen.</source>
            <translation>No alarms stand. One that comes up appears here until it has gone and been seen.</translation>
        </message>
        <message>
            <source>Choose an alarm.</source>
            <translation>Choose an alarm.</translation>
        </message>
        <message>
            <source>Seen by %1.</source>
            <translation>Seen by %1.</translation>
        </message>
        <message>
            <source>It is from an earlier run.</source>
            <translation>It is from an earlier run.</translation>
        </message>
        <message>
            <source>Standing or unseen</source>
            <translation>Standing or unseen</translation>
        </message>
        <message>
            <source>History</source>
            <translation>History</translation>
        </message>
        <message>
            <source>Older</source>
            <translation>Older</translation>
        </message>
        <message>
            <source>Cause</source>
            <translation>Cause</translation>
        </message>
        <message>
            <source>Consequence</source>
            <translation>Consequence</translation>
        </message>
        <message>
            <source>What to do</source>
            <translation>What to do</translation>
        </message>
        <message>
            <source>Seen</source>
            <translation>Seen</translation>
        </message>
        <message>
            <source>All priorities</source>
            <translation>All priorities</translation>
        </message>
        <message>
            <source>Priority 1 and 2</source>
            <translation>Priority 1 and 2</translation>
        </message>
        <message>
            <source>Priority 1 only</source>
            <translation>Priority 1 only</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Export</translation>
        </message>
        <message>
            <source>Export the history</source>
            <translation>Export the history</translation>
        </message>
        <message>
            <source>What the list shows, as CSV. A file that is there already is never written over.</source>
            <translation>What the list shows, as CSV. A file that is there already is never written over.</translation>
        </message>
        <message>
            <source>Written: %1</source>
            <translation>Written: %1</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::BoreChart</name>
        <message>
            <source>part</source>
            <translation>part</translation>
        </message>
        <message>
            <source>bore ⌀</source>
            <translation>bore ⌀</translation>
        </message>
        <message>
            <source>The bore of each part appears here once its diameter is entered.</source>
            <translation>The bore of each part appears here once its diameter is entered.</translation>
        </message>
        <message>
            <source>upper</source>
            <translation>upper</translation>
        </message>
        <message>
            <source>lower</source>
            <translation>lower</translation>
        </message>
        <message>
            <source>Bore against its tolerance, last 25 parts</source>
            <translation>Bore against its tolerance, last 25 parts</translation>
        </message>
        <message>
            <source>expected</source>
            <translation>expected</translation>
        </message>
        <message>
            <source>process changed</source>
            <translation>process changed</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::BoringPage</name>
        <message>
            <source>No boring lot is open on this machine. The page fills as soon as one is.</source>
            <translation>No boring lot is open on this machine. The page fills as soon as one is.</translation>
        </message>
        <message>
            <source>Bore ⌀, %1 – last 25 parts of lot %2</source>
            <comment>unit, lot</comment>
            <translation>Bore ⌀, %1 – last 25 parts of lot %2</translation>
        </message>
        <message>
            <source>Nothing can be stored at the moment: %1</source>
            <translation>Nothing can be stored at the moment: %1</translation>
        </message>
        <message>
            <source>%1 (corrected)</source>
            <translation>%1 (corrected)</translation>
        </message>
        <message>
            <source>%1, expected %2 ± %3</source>
            <comment>diameter, prediction, half interval</comment>
            <translation>%1, expected %2 ± %3</translation>
        </message>
        <message>
            <source>Part %1: %2 %3.</source>
            <comment>number, diameters, unit</comment>
            <translation>Part %1: %2 %3.</translation>
        </message>
        <message>
            <source>Diameters of this lot</source>
            <translation>Diameters of this lot</translation>
        </message>
        <message>
            <source>Touch a value to correct or take it out, an empty place to enter it.</source>
            <translation>Touch a value to correct or take it out, an empty place to enter it.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>Cpk %1 (%2)</source>
            <comment>figure, depth</comment>
            <translation>Cpk %1 (%2)</translation>
        </message>
        <message>
            <source>What is new with the next part?</source>
            <translation>What is new with the next part?</translation>
        </message>
        <message>
            <source>The expected diameters then begin from what such changes have brought before. Nothing known: just go on.</source>
            <translation>The expected diameters then begin from what such changes have brought before. Nothing known: just go on.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Take back</source>
            <translation>Take back</translation>
        </message>
        <message>
            <source>The gauge sent %1: it is taken when somebody signs on.</source>
            <translation>The gauge sent %1: it is taken when somebody signs on.</translation>
        </message>
        <message>
            <source>The gauge sent %1 a while ago: left out, measure again.</source>
            <translation>The gauge sent %1 a while ago: left out, measure again.</translation>
        </message>
        <message>
            <source>Channel %1</source>
            <translation>Channel %1</translation>
        </message>
        <message>
            <source>Gauge %1 is overdue since %2: have it checked before you rely on it.</source>
            <translation>Gauge %1 is overdue since %2: have it checked before you rely on it.</translation>
        </message>
        <message>
            <source>From a file</source>
            <translation>From a file</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>Gauges</translation>
        </message>
        <message>
            <source>Which gauge sends the readings: it is kept with each value. Which channel of a gauge's switch measures at which depth.</source>
            <translation>Which gauge sends the readings: it is kept with each value. Which channel of a gauge's switch measures at which depth.</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>Gauge</translation>
        </message>
        <message>
            <source>not said</source>
            <translation>not said</translation>
        </message>
        <message>
            <source>Gauge at hand</source>
            <translation>Gauge at hand</translation>
        </message>
        <message>
            <source>Learn the channels anew</source>
            <translation>Learn the channels anew</translation>
        </message>
        <message>
            <source>Which gauge is asked?</source>
            <translation>Which gauge is asked?</translation>
        </message>
        <message>
            <source>Touch the one that measures this bore.</source>
            <translation>Touch the one that measures this bore.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::Chart</name>
        <message>
            <source>%1, %2</source>
            <comment>axis title, unit</comment>
            <translation>%1, %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ComparisonPanel</name>
        <message>
            <source>no part is archived yet</source>
            <translation>no part is archived yet</translation>
        </message>
        <message>
            <source>Without and with the loop</source>
            <translation>Without and with the loop</translation>
        </message>
        <message>
            <source>Archive of parts</source>
            <translation>Archive of parts</translation>
        </message>
        <message>
            <source>Cut one part in Advise and one in Control with the same setup: the comparison appears here after the second.</source>
            <translation>Cut one part in Advise and one in Control with the same setup: the comparison appears here after the second.</translation>
        </message>
        <message>
            <source>second half</source>
            <translation>second half</translation>
        </message>
        <message>
            <source>part %1, open</source>
            <translation>part %1, open</translation>
        </message>
        <message>
            <source>part %1, %2</source>
            <comment>number, controller</comment>
            <translation>part %1, %2</translation>
        </message>
        <message>
            <source>change</source>
            <translation>change</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>P-V</source>
            <translation>P-V</translation>
        </message>
        <message>
            <source>mean force</source>
            <translation>mean force</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ContourChart</name>
        <message>
            <source>rev</source>
            <comment>spindle revolutions, on an axis</comment>
            <translation>rev</translation>
        </message>
        <message>
            <source>error</source>
            <translation>error</translation>
        </message>
        <message>
            <source>The contour error of the first tap appears here as soon as it is made.</source>
            <translation>The contour error of the first tap appears here as soon as it is made.</translation>
        </message>
        <message>
            <source>Contour error over the spindle's way, in and out</source>
            <translation>Contour error over the spindle's way, in and out</translation>
        </message>
        <message>
            <source>6H: %1 p-p</source>
            <translation>6H: %1 p-p</translation>
        </message>
        <message>
            <source>reversal</source>
            <translation>reversal</translation>
        </message>
        <message>
            <source>touch: whole course</source>
            <translation>touch: whole course</translation>
        </message>
        <message>
            <source>touch: the band alone</source>
            <translation>touch: the band alone</translation>
        </message>
        <message>
            <source>first tap</source>
            <translation>first tap</translation>
        </message>
        <message>
            <source>last tap</source>
            <translation>last tap</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::DiagnosticsPage</name>
        <message>
            <source>%1 (%2 %)</source>
            <translation>%1 (%2 %)</translation>
        </message>
        <message>
            <source>Real-time scheduling is granted: the cycle goes before all other work of this computer.</source>
            <translation>Real-time scheduling is granted: the cycle goes before all other work of this computer.</translation>
        </message>
        <message>
            <source>Real-time scheduling is not granted: other programs can delay the cycle. Allow it with “rtprio” in /etc/security/limits.conf.</source>
            <translation>Real-time scheduling is not granted: other programs can delay the cycle. Allow it with “rtprio” in /etc/security/limits.conf.</translation>
        </message>
        <message>
            <source>up</source>
            <translation>up</translation>
        </message>
        <message>
            <source>connecting</source>
            <translation>connecting</translation>
        </message>
        <message>
            <source>down</source>
            <translation>down</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>Work in one cycle</source>
            <translation>Work in one cycle</translation>
        </message>
        <message>
            <source>Start after the deadline</source>
            <translation>Start after the deadline</translation>
        </message>
        <message>
            <source>time per cycle; height: share of all cycles</source>
            <translation>time per cycle; height: share of all cycles</translation>
        </message>
        <message>
            <source>lateness; height: share of all cycles</source>
            <translation>lateness; height: share of all cycles</translation>
        </message>
        <message>
            <source>Engine</source>
            <translation>Engine</translation>
        </message>
        <message>
            <source>Machine and versions</source>
            <translation>Machine and versions</translation>
        </message>
        <message>
            <source>Cycles</source>
            <translation>Cycles</translation>
        </message>
        <message>
            <source>Overruns</source>
            <translation>Overruns</translation>
        </message>
        <message>
            <source>Chart samples dropped</source>
            <translation>Chart samples dropped</translation>
        </message>
        <message>
            <source>Machine time per second</source>
            <translation>Machine time per second</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Machine</translation>
        </message>
        <message>
            <source>Link</source>
            <translation>Link</translation>
        </message>
        <message>
            <source>Machine time</source>
            <translation>Machine time</translation>
        </message>
        <message>
            <source>Versions</source>
            <translation>Versions</translation>
        </message>
        <message>
            <source>no database</source>
            <translation>no database</translation>
        </message>
        <message>
            <source>being written</source>
            <translation>being written</translation>
        </message>
        <message>
            <source>Back up all data</source>
            <translation>Back up all data</translation>
        </message>
        <message>
            <source>A checked copy in one file, made while everything goes on. Touch where it shall go.</source>
            <translation>A checked copy in one file, made while everything goes on. Touch where it shall go.</translation>
        </message>
        <message>
            <source>Backed up to %1</source>
            <translation>Backed up to %1</translation>
        </message>
        <message>
            <source>Not backed up: %1</source>
            <translation>Not backed up: %1</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>%1 ms (%2 kHz)</source>
            <translation>%1 ms (%2 kHz)</translation>
        </message>
        <message>
            <source>Period of the cycle</source>
            <translation>Period of the cycle</translation>
        </message>
        <message>
            <source>The simulation runs faster than time: it needs no real-time scheduling and asks for none.</source>
            <translation>The simulation runs faster than time: it needs no real-time scheduling and asks for none.</translation>
        </message>
        <message>
            <source>none: this console keeps its data to itself</source>
            <translation>none: this console keeps its data to itself</translation>
        </message>
        <message>
            <source>Shop</source>
            <translation>Shop</translation>
        </message>
        <message>
            <source>Restore a backup</source>
            <translation>Restore a backup</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::EntryPanel</name>
        <message>
            <source>no part waits</source>
            <translation>no part waits</translation>
        </message>
        <message>
            <source>none fitted</source>
            <translation>none fitted</translation>
        </message>
        <message>
            <source>nothing entered</source>
            <translation>nothing entered</translation>
        </message>
        <message>
            <source>Enter the bore</source>
            <translation>Enter the bore</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>Gauge</translation>
        </message>
        <message>
            <source>Undo last</source>
            <translation>Undo last</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>Correct</translation>
        </message>
        <message>
            <source>Measure again</source>
            <translation>Measure again</translation>
        </message>
        <message>
            <source>⌀ of %1</source>
            <comment>part and depth</comment>
            <translation>⌀ of %1</translation>
        </message>
        <message>
            <source>No part waits for a diameter</source>
            <translation>No part waits for a diameter</translation>
        </message>
        <message>
            <source>For %1 type all figures.</source>
            <translation>For %1 type all figures.</translation>
        </message>
        <message>
            <source>Type the last two figures, or the whole diameter.</source>
            <translation>Type the last two figures, or the whole diameter.</translation>
        </message>
        <message>
            <source>The first part is not cut yet. Its diameters are asked for here.</source>
            <translation>The first part is not cut yet. Its diameters are asked for here.</translation>
        </message>
        <message>
            <source>All parts cut so far are measured.</source>
            <translation>All parts cut so far are measured.</translation>
        </message>
        <message>
            <source>Please answer: measure again, or confirm the value.</source>
            <translation>Please answer: measure again, or confirm the value.</translation>
        </message>
        <message>
            <source>Nothing typed for %1: type its last two figures.</source>
            <translation>Nothing typed for %1: type its last two figures.</translation>
        </message>
        <message>
            <source>“%1” for %2 is one figure short: type the last two, or the whole diameter.</source>
            <translation>“%1” for %2 is one figure short: type the last two, or the whole diameter.</translation>
        </message>
        <message>
            <source>“%1” for %2 is not a number: type a diameter such as %3.</source>
            <translation>“%1” for %2 is not a number: type a diameter such as %3.</translation>
        </message>
        <message>
            <source>Not taken for %1: %2</source>
            <translation>Not taken for %1: %2</translation>
        </message>
        <message>
            <source>Yes, %1</source>
            <translation>Yes, %1</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1: being stored …</source>
            <translation>%1: being stored …</translation>
        </message>
        <message>
            <source>Not stored, %1 is kept here: %2 Enter tries again.</source>
            <translation>Not stored, %1 is kept here: %2 Enter tries again.</translation>
        </message>
        <message>
            <source>%1: %2 from the gauge, stored.</source>
            <translation>%1: %2 from the gauge, stored.</translation>
        </message>
        <message>
            <source>%1: %2 stored.</source>
            <translation>%1: %2 stored.</translation>
        </message>
        <message>
            <source>The gauge sent %1, but no part waits for a diameter: left out.</source>
            <translation>The gauge sent %1, but no part waits for a diameter: left out.</translation>
        </message>
        <message>
            <source>the gauge sent %1: that fits only in inch. Set the gauge to mm.</source>
            <translation>the gauge sent %1: that fits only in inch. Set the gauge to mm.</translation>
        </message>
        <message>
            <source>the gauge sent %1: that fits only in mm. Set the gauge to inch.</source>
            <translation>the gauge sent %1: that fits only in mm. Set the gauge to inch.</translation>
        </message>
        <message>
            <source>Take %1</source>
            <translation>Take %1</translation>
        </message>
        <message>
            <source>the gauge sent %1: its decimal point seems to have slipped.</source>
            <translation>the gauge sent %1: its decimal point seems to have slipped.</translation>
        </message>
        <message>
            <source>The gauge sent %1 twice at once: the second one is left out.</source>
            <translation>The gauge sent %1 twice at once: the second one is left out.</translation>
        </message>
        <message>
            <source>Further readings are left out until this one is stored: send them again then.</source>
            <translation>Further readings are left out until this one is stored: send them again then.</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>gauge channel, depth</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Gauge channels</source>
            <translation>Gauge channels</translation>
        </message>
        <message>
            <source>The gauge sent %1, but channel %2 belongs to no depth: left out.</source>
            <translation>The gauge sent %1, but channel %2 belongs to no depth: left out.</translation>
        </message>
        <message>
            <source>The gauge sent %1 at once behind the others: one too many, left out. For the next part send it again.</source>
            <translation>The gauge sent %1 at once behind the others: one too many, left out. For the next part send it again.</translation>
        </message>
        <message>
            <source>The gauge sent %1, but %2 has its diameter: left out. Use Correct to change it.</source>
            <translation>The gauge sent %1, but %2 has its diameter: left out. Use Correct to change it.</translation>
        </message>
        <message>
            <source>The gauge sent %1: a deviation, and the recipe has no setting ring. Not taken.</source>
            <translation>The gauge sent %1: a deviation, and the recipe has no setting ring. Not taken.</translation>
        </message>
        <message>
            <source>Only a part of a reading came (%1): nothing is taken. Send it again.</source>
            <translation>Only a part of a reading came (%1): nothing is taken. Send it again.</translation>
        </message>
        <message>
            <source>Num Lock is off: the keypad sends no figures. Switch it on and type again.</source>
            <translation>Num Lock is off: the keypad sends no figures. Switch it on and type again.</translation>
        </message>
        <message>
            <source>%1 is kept here and is stored as soon as there is room: %2</source>
            <translation>%1 is kept here and is stored as soon as there is room: %2</translation>
        </message>
        <message>
            <source>The gauge sent %1 for depth %2 of the sensor file; this part type has %3: left out.</source>
            <translation>The gauge sent %1 for depth %2 of the sensor file; this part type has %3: left out.</translation>
        </message>
        <message>
            <source>Which gauge?</source>
            <translation>Which gauge?</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ErrorMap</name>
        <message>
            <source>error in %1, %2</source>
            <translation>error in %1, %2</translation>
        </message>
        <message>
            <source>X 0 to %1, Y 0 to %2</source>
            <translation>X 0 to %1, Y 0 to %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::EstimatePanel</name>
        <message>
            <source>%1, 95 % intervals</source>
            <comment>of estimated figures</comment>
            <translation>%1, 95 % intervals</translation>
        </message>
        <message>
            <source>%1 (%2), 95 % intervals</source>
            <comment>estimated figures, by which estimator</comment>
            <translation>%1 (%2), 95 % intervals</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::EstimateStrips</name>
        <message>
            <source>The estimated constants of the law appear here after the first measured part.</source>
            <translation>The estimated constants of the law appear here after the first measured part.</translation>
        </message>
        <message>
            <source>part</source>
            <translation>part</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::FeedPanel</name>
        <message>
            <source>Feed along the bore, %1</source>
            <comment>unit</comment>
            <translation>Feed along the bore, %1</translation>
        </message>
        <message>
            <source>overhang</source>
            <translation>overhang</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>feed</translation>
        </message>
        <message>
            <source>schedule</source>
            <translation>schedule</translation>
        </message>
        <message>
            <source>last part</source>
            <translation>last part</translation>
        </message>
        <message>
            <source>The feed schedule appears here as soon as a lot is running.</source>
            <translation>The feed schedule appears here as soon as a lot is running.</translation>
        </message>
        <message>
            <source>Feed along the bore: schedule, last part, live cut</source>
            <translation>Feed along the bore: schedule, last part, live cut</translation>
        </message>
        <message>
            <source>live %1</source>
            <translation>live %1</translation>
        </message>
        <message>
            <source>not cutting</source>
            <translation>not cutting</translation>
        </message>
        <message>
            <source>feed not known</source>
            <translation>feed not known</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ForcePanel</name>
        <message>
            <source>Force, %1: extremes and mean, last %2 s</source>
            <comment>unit, seconds</comment>
            <translation>Force, %1: extremes and mean, last %2 s</translation>
        </message>
        <message>
            <source>Depth, %1, last %2 s</source>
            <comment>unit, seconds</comment>
            <translation>Depth, %1, last %2 s</translation>
        </message>
        <message>
            <source>force</source>
            <translation>force</translation>
        </message>
        <message>
            <source>depth</source>
            <translation>depth</translation>
        </message>
        <message>
            <source>from the force</source>
            <translation>from the force</translation>
        </message>
        <message>
            <source>The force appears here as soon as a part is cut.</source>
            <translation>The force appears here as soon as a part is cut.</translation>
        </message>
        <message>
            <source>The depth that is really cut appears here with the first chip.</source>
            <translation>The depth that is really cut appears here with the first chip.</translation>
        </message>
        <message>
            <source>Force live: lowest and highest of every 5 kHz sample, mean, target</source>
            <translation>Force live: lowest and highest of every 5 kHz sample, mean, target</translation>
        </message>
        <message>
            <source>Depth from the force against the programmed depth</source>
            <translation>Depth from the force against the programmed depth</translation>
        </message>
        <message>
            <source>target</source>
            <translation>target</translation>
        </message>
        <message>
            <source>programmed</source>
            <translation>programmed</translation>
        </message>
        <message>
            <source>mean %1</source>
            <translation>mean %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::GainsPanel</name>
        <message>
            <source>before</source>
            <translation>before</translation>
        </message>
        <message>
            <source>now</source>
            <translation>now</translation>
        </message>
        <message>
            <source>next</source>
            <translation>next</translation>
        </message>
        <message>
            <source>trim, %1</source>
            <comment>largest learned trim, unit</comment>
            <translation>trim, %1</translation>
        </message>
        <message>
            <source>Safe Z gain %1 to %2 1/s; unstable from about %3 1/s, %4 dB away.</source>
            <translation>Safe Z gain %1 to %2 1/s; unstable from about %3 1/s, %4 dB away.</translation>
        </message>
        <message>
            <source>The safe set of gains is estimated with the first trial tap.</source>
            <translation>The safe set of gains is estimated with the first trial tap.</translation>
        </message>
        <message>
            <source>This machine has no tapping loop: %1</source>
            <translation>This machine has no tapping loop: %1</translation>
        </message>
        <message>
            <source>Tune again: the sum of errors has grown above that of the first taps.</source>
            <translation>Tune again: the sum of errors has grown above that of the first taps.</translation>
        </message>
        <message>
            <source>Drift watch: %1 % of what asks for a new tune, after %2 taps.</source>
            <translation>Drift watch: %1 % of what asks for a new tune, after %2 taps.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::GaugeSheets</name>
        <message>
            <source>no study yet</source>
            <translation>no study yet</translation>
        </message>
        <message>
            <source>σ %1 (%2 to %3), from a study: %4</source>
            <comment>repeatability with its interval, judgement</comment>
            <translation>σ %1 (%2 to %3), from a study: %4</translation>
        </message>
        <message>
            <source>good enough</source>
            <translation>good enough</translation>
        </message>
        <message>
            <source>not good enough</source>
            <translation>not good enough</translation>
        </message>
        <message>
            <source>no due date</source>
            <translation>no due date</translation>
        </message>
        <message>
            <source>overdue since %1</source>
            <translation>overdue since %1</translation>
        </message>
        <message>
            <source>due on %1</source>
            <translation>due on %1</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>Gauges</translation>
        </message>
        <message>
            <source>Choose a gauge, or enter a new one.</source>
            <translation>Choose a gauge, or enter a new one.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>New gauge</source>
            <translation>New gauge</translation>
        </message>
        <message>
            <source>Lengths in mm; the due date as 2026-12-31.</source>
            <translation>Lengths in mm; the due date as 2026-12-31.</translation>
        </message>
        <message>
            <source>Identity</source>
            <translation>Identity</translation>
        </message>
        <message>
            <source>Range from</source>
            <translation>Range from</translation>
        </message>
        <message>
            <source>Range to</source>
            <translation>Range to</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>Resolution</translation>
        </message>
        <message>
            <source>Setting ring</source>
            <translation>Setting ring</translation>
        </message>
        <message>
            <source>Due date</source>
            <translation>Due date</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Study with one ring</source>
            <translation>Study with one ring</translation>
        </message>
        <message>
            <source>Study with parts and persons</source>
            <translation>Study with parts and persons</translation>
        </message>
        <message>
            <source>Use σ for the lots to come</source>
            <translation>Use σ for the lots to come</translation>
        </message>
        <message>
            <source>Numbers and a date as 2026-12-31 are needed.</source>
            <translation>Numbers and a date as 2026-12-31 are needed.</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Save</translation>
        </message>
        <message>
            <source>No lot is open, so there is no recipe to take it.</source>
            <translation>No lot is open, so there is no recipe to take it.</translation>
        </message>
        <message>
            <source>Stored as a new revision of the recipe: it holds for the next lot.</source>
            <translation>Stored as a new revision of the recipe: it holds for the next lot.</translation>
        </message>
        <message>
            <source>All %1 readings are there. Save the study.</source>
            <translation>All %1 readings are there. Save the study.</translation>
        </message>
        <message>
            <source>Reading %1 of %2 of the ring</source>
            <translation>Reading %1 of %2 of the ring</translation>
        </message>
        <message>
            <source>Person %1, trial %2: part %3</source>
            <translation>Person %1, trial %2: part %3</translation>
        </message>
        <message>
            <source>10 parts, 3 persons, 2 trials each. The person changes when all parts have been read twice.</source>
            <translation>10 parts, 3 persons, 2 trials each. The person changes when all parts have been read twice.</translation>
        </message>
        <message>
            <source>25 readings of the setting ring, taken out and put back each time.</source>
            <translation>25 readings of the setting ring, taken out and put back each time.</translation>
        </message>
        <message>
            <source>Width of the tolerance, mm</source>
            <translation>Width of the tolerance, mm</translation>
        </message>
        <message>
            <source>Reading, mm</source>
            <translation>Reading, mm</translation>
        </message>
        <message>
            <source>“%1” does not lie in the range of the gauge. Read again.</source>
            <translation>“%1” does not lie in the range of the gauge. Read again.</translation>
        </message>
        <message>
            <source>Take back the last reading</source>
            <translation>Take back the last reading</translation>
        </message>
        <message>
            <source>Save the study</source>
            <translation>Save the study</translation>
        </message>
        <message>
            <source>%1 of %2 readings are there; the tolerance must be a number.</source>
            <translation>%1 of %2 readings are there; the tolerance must be a number.</translation>
        </message>
        <message>
            <source>Study with one ring, n %1, tolerance %2: Cg %3, Cgk %4</source>
            <translation>Study with one ring, n %1, tolerance %2: Cg %3, Cgk %4</translation>
        </message>
        <message>
            <source>Study with one ring, n %1, tolerance %2: Cg %3</source>
            <translation>Study with one ring, n %1, tolerance %2: Cg %3</translation>
        </message>
        <message>
            <source>Study with parts and persons, n %1: GRR %2 % of the spread of the parts, %3 % of the tolerance %4, %5 categories</source>
            <translation>Study with parts and persons, n %1: GRR %2 % of the spread of the parts, %3 % of the tolerance %4, %5 categories</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HeaderBar</name>
        <message>
            <source>lot %1</source>
            <translation>lot %1</translation>
        </message>
        <message>
            <source>part %1/%2</source>
            <translation>part %1/%2</translation>
        </message>
        <message>
            <source>emergency stop</source>
            <translation>emergency stop</translation>
        </message>
        <message>
            <source>connected</source>
            <translation>connected</translation>
        </message>
        <message>
            <source>machine off</source>
            <translation>machine off</translation>
        </message>
        <message>
            <source>connecting</source>
            <translation>connecting</translation>
        </message>
        <message>
            <source>no link</source>
            <translation>no link</translation>
        </message>
        <message>
            <source>simulator ×%1</source>
            <translation>simulator ×%1</translation>
        </message>
        <message>
            <source>simulator, free run</source>
            <translation>simulator, free run</translation>
        </message>
        <message>
            <source>Sign on</source>
            <translation>Sign on</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>Language</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>Settings</translation>
        </message>
        <message>
            <source>closed</source>
            <translation>closed</translation>
        </message>
        <message>
            <source>full</source>
            <translation>full</translation>
        </message>
        <message>
            <source>Lots</source>
            <translation>Lots</translation>
        </message>
        <message>
            <source>Help: touch what you want explained</source>
            <translation>Help: touch what you want explained</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HeldBand</name>
        <message>
            <source>HELD: all loops</source>
            <translation>HELD: all loops</translation>
        </message>
        <message>
            <source>STOPPED: a tap stands in the hole</source>
            <translation>STOPPED: a tap stands in the hole</translation>
        </message>
        <message>
            <source>STOPPED: %1</source>
            <translation>STOPPED: %1</translation>
        </message>
        <message>
            <source>Emergency stop is pressed.</source>
            <translation>Emergency stop is pressed.</translation>
        </message>
        <message>
            <source>No link to the machine.</source>
            <translation>No link to the machine.</translation>
        </message>
        <message>
            <source>The machine is off.</source>
            <translation>The machine is off.</translation>
        </message>
        <message>
            <source>HOLD ALL was pressed by %1.</source>
            <translation>HOLD ALL was pressed by %1.</translation>
        </message>
        <message>
            <source>HOLD ALL was pressed, or the machine was stopped or lost: look at it.</source>
            <translation>HOLD ALL was pressed, or the machine was stopped or lost: look at it.</translation>
        </message>
        <message>
            <source>since %1</source>
            <translation>since %1</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>Show</translation>
        </message>
        <message>
            <source>Release stop</source>
            <translation>Release stop</translation>
        </message>
        <message>
            <source>Release hold</source>
            <translation>Release hold</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HelpMode</name>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>The formula</source>
            <translation>The formula</translation>
        </message>
        <message>
            <source>The guide</source>
            <translation>The guide</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HistogramChart</name>
        <message>
            <source>Appears as soon as the engine cycles.</source>
            <translation>Appears as soon as the engine cycles.</translation>
        </message>
        <message>
            <source>cycle</source>
            <translation>cycle</translation>
        </message>
        <message>
            <source>median %1</source>
            <translation>median %1</translation>
        </message>
        <message>
            <source>99.9 % %1</source>
            <translation>99.9 % %1</translation>
        </message>
        <message>
            <source>worst %1</source>
            <translation>worst %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HoldAllButton</name>
        <message>
            <source>HELD – all loops off</source>
            <translation>HELD – all loops off</translation>
        </message>
        <message>
            <source>HOLD ALL</source>
            <translation>HOLD ALL</translation>
        </message>
        <message>
            <source>All loops off, last offset held (Pause key). This is not an emergency stop.</source>
            <translation>All loops off, last offset held (Pause key). This is not an emergency stop.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ImportForm</name>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>being read</source>
            <translation>being read</translation>
        </message>
        <message>
            <source>choose a file first</source>
            <translation>choose a file first</translation>
        </message>
        <message>
            <source>Diameters from a file</source>
            <translation>Diameters from a file</translation>
        </message>
        <message>
            <source>A table with the columns part, overhang and diameter, in any order and spelling. Nothing is taken before you have seen what it would do.</source>
            <translation>A table with the columns part, overhang and diameter, in any order and spelling. Nothing is taken before you have seen what it would do.</translation>
        </message>
        <message>
            <source>or the file's path</source>
            <translation>or the file's path</translation>
        </message>
        <message>
            <source>File</source>
            <translation>File</translation>
        </message>
        <message>
            <source>Look into it</source>
            <translation>Look into it</translation>
        </message>
        <message>
            <source>Take over</source>
            <translation>Take over</translation>
        </message>
        <message>
            <source>a moment</source>
            <translation>a moment</translation>
        </message>
        <message>
            <source>look into a file first</source>
            <translation>look into a file first</translation>
        </message>
        <message>
            <source>it cannot be read</source>
            <translation>it cannot be read</translation>
        </message>
        <message>
            <source>a row is refused</source>
            <translation>a row is refused</translation>
        </message>
        <message>
            <source>nothing new in it</source>
            <translation>nothing new in it</translation>
        </message>
        <message>
            <source>A moment …</source>
            <translation>A moment …</translation>
        </message>
        <message>
            <source>Nothing is taken: %1</source>
            <translation>Nothing is taken: %1</translation>
        </message>
        <message>
            <source>Line %1: %2</source>
            <translation>Line %1: %2</translation>
        </message>
        <message>
            <source>%1 would be entered: %2 diameters of parts %3 to %4, from %5 to %6.</source>
            <translation>%1 would be entered: %2 diameters of parts %3 to %4, from %5 to %6.</translation>
        </message>
        <message>
            <source>%1 diameters taken over from %2.</source>
            <translation>%1 diameters taken over from %2.</translation>
        </message>
        <message>
            <source>Yes, take all %1 as they are</source>
            <translation>Yes, take all %1 as they are</translation>
        </message>
        <message>
            <source>Take %1 diameters</source>
            <translation>Take %1 diameters</translation>
        </message>
        <message>
            <source>%1 of its values are stored already.</source>
            <translation>%1 of its values are stored already.</translation>
        </message>
        <message>
            <source>… and %1 more like it.</source>
            <translation>… and %1 more like it.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::JobForm</name>
        <message>
            <source>What is tapped</source>
            <translation>What is tapped</translation>
        </message>
        <message>
            <source>coarse</source>
            <translation>coarse</translation>
        </message>
        <message>
            <source>fine</source>
            <translation>fine</translation>
        </message>
        <message>
            <source>speed</source>
            <translation>speed</translation>
        </message>
        <message>
            <source>depth</source>
            <translation>depth</translation>
        </message>
        <message>
            <source>gear</source>
            <translation>gear</translation>
        </message>
        <message>
            <source>part type no.</source>
            <translation>part type no.</translation>
        </message>
        <message>
            <source>tap no.</source>
            <translation>tap no.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Load</source>
            <translation>Load</translation>
        </message>
        <message>
            <source>%1: pitch diameter 6H (ISO 965-1) allows %2 p-p in the work, %3 with a tap at its upper limit.</source>
            <translation>%1: pitch diameter 6H (ISO 965-1) allows %2 p-p in the work, %3 with a tap at its upper limit.</translation>
        </message>
        <message>
            <source>Reason</source>
            <translation>Reason</translation>
        </message>
        <message>
            <source>A stored tuning is left out, %1.</source>
            <comment>by whom and why</comment>
            <translation>A stored tuning is left out, %1.</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>Take in again</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>Leave out</translation>
        </message>
        <message>
            <source>%1: pitch diameter 2B (ASME B1.1) allows %2 p-p in the work, %3 with a tap at its upper limit.</source>
            <translation>%1: pitch diameter 2B (ASME B1.1) allows %2 p-p in the work, %3 with a tap at its upper limit.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::Keypad</name>
        <message>
            <source>Enter</source>
            <translation>Enter</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>Clear</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::LastVerdict</name>
        <message>
            <source>Part %1: %2, no limits are set</source>
            <translation>Part %1: %2, no limits are set</translation>
        </message>
        <message>
            <source>Part %1: %2, %3</source>
            <comment>verdict, figure</comment>
            <translation>Part %1: %2, %3</translation>
        </message>
        <message>
            <source>Part %1: %2</source>
            <translation>Part %1: %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::LoopCard</name>
        <message>
            <source>not fitted</source>
            <translation>not fitted</translation>
        </message>
        <message>
            <source>Not fitted yet.</source>
            <translation>Not fitted yet.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::LotForm</name>
        <message>
            <source>Lots</source>
            <translation>Lots</translation>
        </message>
        <message>
            <source>Next lot of part type</source>
            <translation>Next lot of part type</translation>
        </message>
        <message>
            <source>Lot</source>
            <translation>Lot</translation>
        </message>
        <message>
            <source>Estimator kalman</source>
            <translation>Estimator kalman</translation>
        </message>
        <message>
            <source>perturbation (paper)</source>
            <translation>perturbation (paper)</translation>
        </message>
        <message>
            <source>Reason, when the lot is closed before it is full</source>
            <translation>Reason, when the lot is closed before it is full</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Back</translation>
        </message>
        <message>
            <source>Close this lot</source>
            <translation>Close this lot</translation>
        </message>
        <message>
            <source>Recipe</source>
            <translation>Recipe</translation>
        </message>
        <message>
            <source>New part type</source>
            <translation>New part type</translation>
        </message>
        <message>
            <source>Go on with it</source>
            <translation>Go on with it</translation>
        </message>
        <message>
            <source>Open the lot</source>
            <translation>Open the lot</translation>
        </message>
        <message>
            <source>It is closed.</source>
            <translation>It is closed.</translation>
        </message>
        <message>
            <source>It is full.</source>
            <translation>It is full.</translation>
        </message>
        <message>
            <source>It goes on.</source>
            <translation>It goes on.</translation>
        </message>
        <message>
            <source>Now: %1, lot %2, %3 of %4 parts cut, recipe revision %5. %6</source>
            <comment>part type, lot, counts, state</comment>
            <translation>Now: %1, lot %2, %3 of %4 parts cut, recipe revision %5. %6</translation>
        </message>
        <message>
            <source>Part type</source>
            <translation>Part type</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Parts</translation>
        </message>
        <message>
            <source>Opened</source>
            <translation>Opened</translation>
        </message>
        <message>
            <source>State</source>
            <translation>State</translation>
        </message>
        <message>
            <source>current</source>
            <translation>current</translation>
        </message>
        <message>
            <source>closed</source>
            <translation>closed</translation>
        </message>
        <message>
            <source>open</source>
            <translation>open</translation>
        </message>
        <message>
            <source>The newest recipe of the part type holds for a new lot, and stays with it.</source>
            <translation>The newest recipe of the part type holds for a new lot, and stays with it.</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>being stored</translation>
        </message>
        <message>
            <source>a lot needs a name</source>
            <translation>a lot needs a name</translation>
        </message>
        <message>
            <source>touch a lot in the list</source>
            <translation>touch a lot in the list</translation>
        </message>
        <message>
            <source>this lot is current</source>
            <translation>this lot is current</translation>
        </message>
        <message>
            <source>it is closed</source>
            <translation>it is closed</translation>
        </message>
        <message>
            <source>give a reason: it is not full</source>
            <translation>give a reason: it is not full</translation>
        </message>
        <message>
            <source>Lot %1 goes on.</source>
            <translation>Lot %1 goes on.</translation>
        </message>
        <message>
            <source>The lot is closed.</source>
            <translation>The lot is closed.</translation>
        </message>
        <message>
            <source>Insert grade</source>
            <translation>Insert grade</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Material</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>Take in again</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>Leave out</translation>
        </message>
        <message>
            <source>Counts</source>
            <comment>share of a lot in what this one began from</comment>
            <translation>Counts</translation>
        </message>
        <message>
            <source>left out</source>
            <translation>left out</translation>
        </message>
        <message>
            <source>touch a lot that the current one begins from</source>
            <translation>touch a lot that the current one begins from</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>give a reason</translation>
        </message>
        <message>
            <source>Lot %1 counts again.</source>
            <translation>Lot %1 counts again.</translation>
        </message>
        <message>
            <source>Lot %1 is left out of what lots begin from.</source>
            <translation>Lot %1 is left out of what lots begin from.</translation>
        </message>
        <message numerus="yes">
            <source>%n bores wait for diameters</source>
            <translation>
                <numerusform>%n bore waits for diameters</numerusform>
                <numerusform>%n bores wait for diameters</numerusform>
            </translation>
        </message>
        <message>
            <source>Part %1 of this lot waits for its diameter. It is kept when another lot is opened; go on with this lot to enter it.</source>
            <translation>Part %1 of this lot waits for its diameter. It is kept when another lot is opened; go on with this lot to enter it.</translation>
        </message>
        <message>
            <source>Lot %1 is open. Its first part is started by hand.</source>
            <translation>Lot %1 is open. Its first part is started by hand.</translation>
        </message>
        <message>
            <source>Lot %1 is open. Part %2 of lot %3 still waits for its diameter: Lots, Go on with it.</source>
            <translation>Lot %1 is open. Part %2 of lot %3 still waits for its diameter: Lots, Go on with it.</translation>
        </message>
        <message>
            <source>on machine %1</source>
            <translation>on machine %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MachineDrawing</name>
        <message>
            <source>The thermocouples appear here as soon as the machine reports them.</source>
            <translation>The thermocouples appear here as soon as the machine reports them.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MachineStrip</name>
        <message>
            <source>Force</source>
            <translation>Force</translation>
        </message>
        <message>
            <source>%1, paused</source>
            <translation>%1, paused</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>Program</translation>
        </message>
        <message>
            <source>none runs</source>
            <translation>none runs</translation>
        </message>
        <message>
            <source>S</source>
            <translation>S</translation>
        </message>
        <message>
            <source>F</source>
            <translation>F</translation>
        </message>
        <message>
            <source>Knob</source>
            <translation>Knob</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>Tool</translation>
        </message>
        <message numerus="yes">
            <source>%n parts left</source>
            <translation>
                <numerusform>%n part left</numerusform>
                <numerusform>%n parts left</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n parts</source>
            <translation>
                <numerusform>%n part</numerusform>
                <numerusform>%n parts</numerusform>
            </translation>
        </message>
        <message>
            <source>To go</source>
            <translation>To go</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MainWindow</name>
        <message>
            <source>Not done: %1</source>
            <translation>Not done: %1</translation>
        </message>
        <message>
            <source>Kerf – operator console</source>
            <translation>Kerf – operator console</translation>
        </message>
        <message>
            <source>Simulator speed</source>
            <translation>Simulator speed</translation>
        </message>
        <message>
            <source>Machine time per second on the clock.</source>
            <translation>Machine time per second on the clock.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>gone since %1, not seen yet</source>
            <translation>gone since %1, not seen yet</translation>
        </message>
        <message>
            <source>The data file</source>
            <translation>The data file</translation>
        </message>
        <message>
            <source>Finished parts wait</source>
            <translation>Finished parts wait</translation>
        </message>
        <message>
            <source>The store does not take %1 finished parts. Ending Kerf keeps them beside the data file; the next start stores them.</source>
            <translation>The store does not take %1 finished parts. Ending Kerf keeps them beside the data file; the next start stores them.</translation>
        </message>
        <message>
            <source>Stay</source>
            <translation>Stay</translation>
        </message>
        <message>
            <source>End Kerf</source>
            <translation>End Kerf</translation>
        </message>
        <message>
            <source>A part is being cut</source>
            <translation>A part is being cut</translation>
        </message>
        <message>
            <source>Ending Kerf lets go of it: the machine goes on at or below its planned feed, with its last offset, and what is cut from now on is not recorded.</source>
            <translation>Ending Kerf lets go of it: the machine goes on at or below its planned feed, with its last offset, and what is cut from now on is not recorded.</translation>
        </message>
        <message>
            <source>Touch what you want explained.</source>
            <translation>Touch what you want explained.</translation>
        </message>
        <message>
            <source>Close what is open first: it keeps the language it was opened in.</source>
            <translation>Close what is open first: it keeps the language it was opened in.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MarginPanel</name>
        <message>
            <source>Margins appear as soon as a law acts.</source>
            <translation>Margins appear as soon as a law acts.</translation>
        </message>
        <message>
            <source>Guaranteed for every process within the 95 % intervals.</source>
            <translation>Guaranteed for every process within the 95 % intervals.</translation>
        </message>
        <message>
            <source>For the process the law assumes; it is not identified.</source>
            <translation>For the process the law assumes; it is not identified.</translation>
        </message>
        <message>
            <source>trim %1 of ± %2</source>
            <comment>applied trim, authority</comment>
            <translation>trim %1 of ± %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MeasurementForm</name>
        <message>
            <source>%1: %2</source>
            <comment>part and depth, diameter</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>The old value stays on record. The law and all later parts are computed again without it.</source>
            <translation>The old value stays on record. The law and all later parts are computed again without it.</translation>
        </message>
        <message>
            <source>Correct the value</source>
            <translation>Correct the value</translation>
        </message>
        <message>
            <source>Take it out</source>
            <translation>Take it out</translation>
        </message>
        <message>
            <source>typed wrong</source>
            <translation>typed wrong</translation>
        </message>
        <message>
            <source>measured wrong</source>
            <translation>measured wrong</translation>
        </message>
        <message>
            <source>wrong part or depth</source>
            <translation>wrong part or depth</translation>
        </message>
        <message>
            <source>gauge not set</source>
            <translation>gauge not set</translation>
        </message>
        <message>
            <source>Why?</source>
            <translation>Why?</translation>
        </message>
        <message>
            <source>or in your own words</source>
            <translation>or in your own words</translation>
        </message>
        <message>
            <source>signed by %1</source>
            <translation>signed by %1</translation>
        </message>
        <message>
            <source>Leave as it is</source>
            <translation>Leave as it is</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>being stored</translation>
        </message>
        <message>
            <source>nobody is signed on</source>
            <translation>nobody is signed on</translation>
        </message>
        <message>
            <source>the right diameter is missing</source>
            <translation>the right diameter is missing</translation>
        </message>
        <message>
            <source>a reason is missing</source>
            <translation>a reason is missing</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>Correct</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>Take out</translation>
        </message>
        <message>
            <source>Not changed: %1</source>
            <translation>Not changed: %1</translation>
        </message>
        <message>
            <source>This bore then waits for a diameter again.</source>
            <translation>This bore then waits for a diameter again.</translation>
        </message>
        <message>
            <source>%1 becomes %2.</source>
            <comment>diameters</comment>
            <translation>%1 becomes %2.</translation>
        </message>
        <message>
            <source>Type the right diameter: its last two figures, or the whole.</source>
            <translation>Type the right diameter: its last two figures, or the whole.</translation>
        </message>
        <message>
            <source>%1: %2 corrected to %3.</source>
            <translation>%1: %2 corrected to %3.</translation>
        </message>
        <message>
            <source>%1: %2 taken out.</source>
            <translation>%1: %2 taken out.</translation>
        </message>
        <message>
            <source>Num Lock is off: the keypad sends no figures. Switch it on and type again.</source>
            <translation>Num Lock is off: the keypad sends no figures. Switch it on and type again.</translation>
        </message>
        <message>
            <source>The gauge sent %1: not used. To put it in, touch “Correct the value” first and send it again.</source>
            <translation>The gauge sent %1: not used. To put it in, touch “Correct the value” first and send it again.</translation>
        </message>
        <message>
            <source>The gauge sent %1: a deviation, and the recipe has no setting ring. Not used.</source>
            <translation>The gauge sent %1: a deviation, and the recipe has no setting ring. Not used.</translation>
        </message>
        <message>
            <source>Yes, %1</source>
            <translation>Yes, %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MeasurementList</name>
        <message>
            <source>part</source>
            <translation>part</translation>
        </message>
        <message>
            <source>⌀ %1</source>
            <translation>⌀ %1</translation>
        </message>
        <message>
            <source>enter</source>
            <translation>enter</translation>
        </message>
        <message>
            <source>%1 (corrected)</source>
            <translation>%1 (corrected)</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingBlankForm</name>
        <message>
            <source>There is no step.</source>
            <translation>There is no step.</translation>
        </message>
        <message>
            <source>Blank profile of %1</source>
            <translation>Blank profile of %1</translation>
        </message>
        <message>
            <source>Height of the blank over the finished wall, step by step along the path.</source>
            <translation>Height of the blank over the finished wall, step by step along the path.</translation>
        </message>
        <message>
            <source>path</source>
            <translation>path</translation>
        </message>
        <message>
            <source>height</source>
            <translation>height</translation>
        </message>
        <message>
            <source>The profile appears here with its first step.</source>
            <translation>The profile appears here with its first step.</translation>
        </message>
        <message>
            <source>Blank profile along the path</source>
            <translation>Blank profile along the path</translation>
        </message>
        <message>
            <source>Add step</source>
            <translation>Add step</translation>
        </message>
        <message>
            <source>Remove last</source>
            <translation>Remove last</translation>
        </message>
        <message>
            <source>Import CSV</source>
            <translation>Import CSV</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Save and use</source>
            <translation>Save and use</translation>
        </message>
        <message numerus="yes">
            <source>%n steps imported; look at the profile, then save.</source>
            <translation>
                <numerusform>%n step imported; look at the profile, then save.</numerusform>
                <numerusform>%n steps imported; look at the profile, then save.</numerusform>
            </translation>
        </message>
        <message>
            <source>The step that is typed is not added yet.</source>
            <translation>The step that is typed is not added yet.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingControlPanel</name>
        <message>
            <source>Nothing is stopped.</source>
            <translation>Nothing is stopped.</translation>
        </message>
        <message>
            <source>reference force</source>
            <translation>reference force</translation>
        </message>
        <message>
            <source>peak of this cut</source>
            <translation>peak of this cut</translation>
        </message>
        <message>
            <source>Feed law</source>
            <translation>Feed law</translation>
        </message>
        <message>
            <source>Teach reference from this cut</source>
            <translation>Teach reference from this cut</translation>
        </message>
        <message>
            <source>Start cut</source>
            <translation>Start cut</translation>
        </message>
        <message>
            <source>Release feed</source>
            <translation>Release feed</translation>
        </message>
        <message>
            <source>Milling</source>
            <translation>Milling</translation>
        </message>
        <message>
            <source>control would save</source>
            <translation>control would save</translation>
        </message>
        <message>
            <source>saved so far</source>
            <translation>saved so far</translation>
        </message>
        <message>
            <source>%1 s above 110 % of the reference</source>
            <translation>%1 s above 110 % of the reference</translation>
        </message>
        <message>
            <source>; control would have stopped the feed</source>
            <translation>; control would have stopped the feed</translation>
        </message>
        <message>
            <source>; the feed was stopped</source>
            <translation>; the feed was stopped</translation>
        </message>
        <message>
            <source>This machine has no milling loop: %1</source>
            <translation>This machine has no milling loop: %1</translation>
        </message>
        <message>
            <source>No cut to learn from yet.</source>
            <translation>No cut to learn from yet.</translation>
        </message>
        <message>
            <source>This machine has no milling loop.</source>
            <translation>This machine has no milling loop.</translation>
        </message>
        <message>
            <source>No milling setup is loaded.</source>
            <translation>No milling setup is loaded.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingLivePanel</name>
        <message>
            <source>Force per revolution, %1, and feed, %2</source>
            <comment>units</comment>
            <translation>Force per revolution, %1, and feed, %2</translation>
        </message>
        <message>
            <source>time</source>
            <translation>time</translation>
        </message>
        <message>
            <source>force</source>
            <translation>force</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>feed</translation>
        </message>
        <message>
            <source>average</source>
            <translation>average</translation>
        </message>
        <message>
            <source>wanted</source>
            <translation>wanted</translation>
        </message>
        <message>
            <source>The cutting force appears here with the next cut.</source>
            <translation>The cutting force appears here with the next cut.</translation>
        </message>
        <message>
            <source>The feed appears here with the next cut.</source>
            <translation>The feed appears here with the next cut.</translation>
        </message>
        <message>
            <source>Cutting force averaged per revolution, over time</source>
            <translation>Cutting force averaged per revolution, over time</translation>
        </message>
        <message>
            <source>Feed made and wanted, over time</source>
            <translation>Feed made and wanted, over time</translation>
        </message>
        <message>
            <source>Raw force</source>
            <translation>Raw force</translation>
        </message>
        <message>
            <source>planned</source>
            <translation>planned</translation>
        </message>
        <message>
            <source>reference</source>
            <translation>reference</translation>
        </message>
        <message>
            <source>limit</source>
            <translation>limit</translation>
        </message>
        <message>
            <source>loop %1 Hz</source>
            <translation>loop %1 Hz</translation>
        </message>
        <message>
            <source>breakage not seen</source>
            <translation>breakage not seen</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingPage</name>
        <message>
            <source>Nothing cut yet.</source>
            <translation>Nothing cut yet.</translation>
        </message>
        <message>
            <source>This machine has no milling loop.</source>
            <translation>This machine has no milling loop.</translation>
        </message>
        <message>
            <source>Setup</source>
            <translation>Setup</translation>
        </message>
        <message>
            <source>Blank profile</source>
            <translation>Blank profile</translation>
        </message>
        <message>
            <source>Cut log</source>
            <translation>Cut log</translation>
        </message>
        <message>
            <source>New tool</source>
            <translation>New tool</translation>
        </message>
        <message>
            <source>Milling data: %1</source>
            <translation>Milling data: %1</translation>
        </message>
        <message>
            <source>A part is being cut.</source>
            <translation>A part is being cut.</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>being stored</translation>
        </message>
        <message>
            <source>New tool?</source>
            <translation>New tool?</translation>
        </message>
        <message>
            <source>Wear and stiffness of the tool are learnt anew from the next cut on.</source>
            <translation>Wear and stiffness of the tool are learnt anew from the next cut on.</translation>
        </message>
        <message>
            <source>No</source>
            <translation>No</translation>
        </message>
        <message>
            <source>Tools before</source>
            <translation>Tools before</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingSetupForm</name>
        <message>
            <source>This part type is open.</source>
            <translation>This part type is open.</translation>
        </message>
        <message>
            <source>No part type of this name is stored.</source>
            <translation>No part type of this name is stored.</translation>
        </message>
        <message>
            <source>%1: %2 to %3; default %4, %5.</source>
            <comment>label, lowest, highest, default, source</comment>
            <translation>%1: %2 to %3; default %4, %5.</translation>
        </message>
        <message>
            <source>Setup of a milled part type</source>
            <translation>Setup of a milled part type</translation>
        </message>
        <message>
            <source>Part type</source>
            <translation>Part type</translation>
        </message>
        <message>
            <source>Force and feed</source>
            <translation>Force and feed</translation>
        </message>
        <message>
            <source>Path and tool</source>
            <translation>Path and tool</translation>
        </message>
        <message>
            <source>Model and gains</source>
            <translation>Model and gains</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Open</translation>
        </message>
        <message>
            <source>Save and use</source>
            <translation>Save and use</translation>
        </message>
        <message>
            <source>Stored part types ▾</source>
            <translation>Stored part types ▾</translation>
        </message>
        <message>
            <source>Reason, when a limit is raised</source>
            <translation>Reason, when a limit is raised</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingToolPanel</name>
        <message>
            <source>part</source>
            <translation>part</translation>
        </message>
        <message>
            <source>The wear of the tool appears here after its first part.</source>
            <translation>The wear of the tool appears here after its first part.</translation>
        </message>
        <message>
            <source>Mean cutting stiffness over the parts cut with this tool</source>
            <translation>Mean cutting stiffness over the parts cut with this tool</translation>
        </message>
        <message>
            <source>change the tool</source>
            <translation>change the tool</translation>
        </message>
        <message>
            <source>New tool: nothing cut with it yet.</source>
            <translation>New tool: nothing cut with it yet.</translation>
        </message>
        <message>
            <source>Part %1 with this tool, stiffness %2 % above new.</source>
            <comment>parts, rise</comment>
            <translation>Part %1 with this tool, stiffness %2 % above new.</translation>
        </message>
        <message>
            <source>Trend %1 % per part.</source>
            <translation>Trend %1 % per part.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingWallPanel</name>
        <message>
            <source>Wall deviation, %1</source>
            <comment>unit</comment>
            <translation>Wall deviation, %1</translation>
        </message>
        <message>
            <source>path</source>
            <translation>path</translation>
        </message>
        <message>
            <source>deviation</source>
            <translation>deviation</translation>
        </message>
        <message>
            <source>cut before</source>
            <translation>cut before</translation>
        </message>
        <message>
            <source>The estimated wall appears here while a part is being cut.</source>
            <translation>The estimated wall appears here while a part is being cut.</translation>
        </message>
        <message>
            <source>Estimated deviation of the wall along the path</source>
            <translation>Estimated deviation of the wall along the path</translation>
        </message>
        <message>
            <source>waviness %1</source>
            <translation>waviness %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::NextPartPanel</name>
        <message>
            <source>feed, top to bottom of the bore</source>
            <translation>feed, top to bottom of the bore</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Accept</translation>
        </message>
        <message>
            <source>at limit</source>
            <translation>at limit</translation>
        </message>
        <message>
            <source>Next part: %1</source>
            <translation>Next part: %1</translation>
        </message>
        <message>
            <source>⌀ %1, expected</source>
            <translation>⌀ %1, expected</translation>
        </message>
        <message>
            <source>%1 → %2</source>
            <comment>feed at the top and at the bottom of the bore</comment>
            <translation>%1 → %2</translation>
        </message>
        <message>
            <source>This machine has no boring loop: %1</source>
            <translation>This machine has no boring loop: %1</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>being stored</translation>
        </message>
        <message>
            <source>no schedule yet</source>
            <translation>no schedule yet</translation>
        </message>
        <message>
            <source>the loop is off</source>
            <translation>the loop is off</translation>
        </message>
        <message>
            <source>in control, every schedule is used by itself</source>
            <translation>in control, every schedule is used by itself</translation>
        </message>
        <message>
            <source>this schedule is accepted</source>
            <translation>this schedule is accepted</translation>
        </message>
        <message>
            <source>Next lot</source>
            <translation>Next lot</translation>
        </message>
        <message>
            <source>Lot %1 is closed</source>
            <translation>Lot %1 is closed</translation>
        </message>
        <message>
            <source>Lot %1 is full: %2 parts</source>
            <translation>Lot %1 is full: %2 parts</translation>
        </message>
        <message>
            <source>Announced: %1</source>
            <translation>Announced: %1</translation>
        </message>
        <message>
            <source>Tool or material changed</source>
            <translation>Tool or material changed</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::NumberDisplay</name>
        <message>
            <source>%1 s old</source>
            <translation>%1 s old</translation>
        </message>
        <message>
            <source>at limit</source>
            <translation>at limit</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::OffsetPanel</name>
        <message>
            <source>at limit</source>
            <translation>at limit</translation>
        </message>
        <message>
            <source>shifted %1</source>
            <translation>shifted %1</translation>
        </message>
        <message>
            <source>shift not reported</source>
            <translation>shift not reported</translation>
        </message>
        <message>
            <source>shifted %1, would be %2</source>
            <translation>shifted %1, would be %2</translation>
        </message>
        <message>
            <source>This machine has no thermal loop: %1</source>
            <translation>This machine has no thermal loop: %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::OperatorSession</name>
        <message>
            <source>operator</source>
            <translation>operator</translation>
        </message>
        <message>
            <source>setter</source>
            <translation>setter</translation>
        </message>
        <message>
            <source>process engineer</source>
            <translation>process engineer</translation>
        </message>
        <message>
            <source>Only a process engineer may do this.</source>
            <translation>Only a process engineer may do this.</translation>
        </message>
        <message>
            <source>Only a setter or a process engineer may do this.</source>
            <translation>Only a setter or a process engineer may do this.</translation>
        </message>
        <message>
            <source>Only a process engineer may give this role.</source>
            <translation>Only a process engineer may give this role.</translation>
        </message>
        <message>
            <source>Several wrong PINs were typed: wait %1 s.</source>
            <translation>Several wrong PINs were typed: wait %1 s.</translation>
        </message>
        <message>
            <source>Sign on first.</source>
            <translation>Sign on first.</translation>
        </message>
        <message>
            <source>Nobody takes himself off the list.</source>
            <translation>Nobody takes himself off the list.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::OverviewPage</name>
        <message>
            <source>Nothing is held.</source>
            <translation>Nothing is held.</translation>
        </message>
        <message>
            <source>All loops are held with their last offset.</source>
            <translation>All loops are held with their last offset.</translation>
        </message>
        <message>
            <source>Ready for the next part.</source>
            <translation>Ready for the next part.</translation>
        </message>
        <message>
            <source>Cutting, %1 s to go.</source>
            <translation>Cutting, %1 s to go.</translation>
        </message>
        <message>
            <source>The program is running.</source>
            <translation>The program is running.</translation>
        </message>
        <message>
            <source>The program is paused.</source>
            <translation>The program is paused.</translation>
        </message>
        <message>
            <source>Part finished.</source>
            <translation>Part finished.</translation>
        </message>
        <message>
            <source>The last part was aborted.</source>
            <translation>The last part was aborted.</translation>
        </message>
        <message>
            <source>cutting</source>
            <translation>cutting</translation>
        </message>
        <message>
            <source>ready</source>
            <translation>ready</translation>
        </message>
        <message>
            <source>off</source>
            <translation>off</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Machine</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Feed</translation>
        </message>
        <message>
            <source>Parts since start</source>
            <translation>Parts since start</translation>
        </message>
        <message>
            <source>Start part</source>
            <translation>Start part</translation>
        </message>
        <message>
            <source>Release hold</source>
            <translation>Release hold</translation>
        </message>
        <message>
            <source>Stopped: %1</source>
            <translation>Stopped: %1</translation>
        </message>
        <message>
            <source>Release stop</source>
            <translation>Release stop</translation>
        </message>
        <message>
            <source>Shop: %1</source>
            <translation>Shop: %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::PartDetailPanel</name>
        <message>
            <source>overhang</source>
            <translation>overhang</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>feed</translation>
        </message>
        <message>
            <source>feed, %1</source>
            <comment>unit</comment>
            <translation>feed, %1</translation>
        </message>
        <message>
            <source>schedule</source>
            <translation>schedule</translation>
        </message>
        <message>
            <source>cut</source>
            <translation>cut</translation>
        </message>
        <message>
            <source>The feed of the part appears here when one is chosen.</source>
            <translation>The feed of the part appears here when one is chosen.</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>Correct</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>Take out</translation>
        </message>
        <message>
            <source>No part chosen</source>
            <translation>No part chosen</translation>
        </message>
        <message>
            <source>Touch a row of the table.</source>
            <translation>Touch a row of the table.</translation>
        </message>
        <message>
            <source>Part %1, lot %2</source>
            <translation>Part %1, lot %2</translation>
        </message>
        <message>
            <source>cut in %1 s</source>
            <translation>cut in %1 s</translation>
        </message>
        <message>
            <source>serial %1</source>
            <translation>serial %1</translation>
        </message>
        <message>
            <source>aborted</source>
            <translation>aborted</translation>
        </message>
        <message>
            <source>process change noticed</source>
            <translation>process change noticed</translation>
        </message>
        <message>
            <source>depth</source>
            <translation>depth</translation>
        </message>
        <message>
            <source>⌀, %1</source>
            <translation>⌀, %1</translation>
        </message>
        <message>
            <source>by, when</source>
            <translation>by, when</translation>
        </message>
        <message>
            <source>what, why</source>
            <translation>what, why</translation>
        </message>
        <message>
            <source>correction</source>
            <translation>correction</translation>
        </message>
        <message>
            <source>taken out</source>
            <translation>taken out</translation>
        </message>
        <message>
            <source>confirmed</source>
            <translation>confirmed</translation>
        </message>
        <message>
            <source>no longer holds</source>
            <translation>no longer holds</translation>
        </message>
        <message>
            <source>no part chosen</source>
            <translation>no part chosen</translation>
        </message>
        <message>
            <source>choose a diameter that holds</source>
            <translation>choose a diameter that holds</translation>
        </message>
        <message>
            <source>no database</source>
            <translation>no database</translation>
        </message>
        <message>
            <source>Serial</source>
            <translation>Serial</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>Report</translation>
        </message>
        <message>
            <source>%1, part %2</source>
            <translation>%1, part %2</translation>
        </message>
        <message>
            <source>No course of the feed is kept for this part.</source>
            <translation>No course of the feed is kept for this part.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::PartsModel</name>
        <message>
            <source>finished</source>
            <translation>finished</translation>
        </message>
        <message>
            <source>aborted</source>
            <translation>aborted</translation>
        </message>
        <message>
            <source>%1 corrected</source>
            <translation>%1 corrected</translation>
        </message>
        <message>
            <source>%1 voided</source>
            <translation>%1 voided</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>Part</translation>
        </message>
        <message>
            <source>Serial number</source>
            <translation>Serial number</translation>
        </message>
        <message>
            <source>Part type</source>
            <translation>Part type</translation>
        </message>
        <message>
            <source>Lot</source>
            <translation>Lot</translation>
        </message>
        <message>
            <source>Ended</source>
            <translation>Ended</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>Result</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>Changes</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Verdict</translation>
        </message>
        <message>
            <source>Measured, bores in %1</source>
            <translation>Measured, bores in %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::PartsPage</name>
        <message>
            <source>no lot is open</source>
            <translation>no lot is open</translation>
        </message>
        <message>
            <source>%1 rows written to %2.</source>
            <translation>%1 rows written to %2.</translation>
        </message>
        <message>
            <source>Nothing exported: %1</source>
            <translation>Nothing exported: %1</translation>
        </message>
        <message>
            <source>This console has no database, so there are no parts to show.</source>
            <translation>This console has no database, so there are no parts to show.</translation>
        </message>
        <message>
            <source>Search: lot, part type, serial number</source>
            <translation>Search: lot, part type, serial number</translation>
        </message>
        <message>
            <source>This lot</source>
            <translation>This lot</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Export</translation>
        </message>
        <message>
            <source>More than %1 parts, newest first</source>
            <translation>More than %1 parts, newest first</translation>
        </message>
        <message>
            <source>No part matches. Finished parts appear here by themselves.</source>
            <translation>No part matches. Finished parts appear here by themselves.</translation>
        </message>
        <message>
            <source>%1 parts, newest first</source>
            <translation>%1 parts, newest first</translation>
        </message>
        <message>
            <source>part %1, %2 deep</source>
            <comment>part number, position</comment>
            <translation>part %1, %2 deep</translation>
        </message>
        <message>
            <source>no database</source>
            <translation>no database</translation>
        </message>
        <message>
            <source>being written</source>
            <translation>being written</translation>
        </message>
        <message>
            <source>Export as CSV</source>
            <translation>Export as CSV</translation>
        </message>
        <message>
            <source>All parts that the search shows, oldest first, in mm whatever the screen shows.</source>
            <translation>All parts that the search shows, oldest first, in mm whatever the screen shows.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Parts</translation>
        </message>
        <message>
            <source>Measurements</source>
            <translation>Measurements</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Feed</translation>
        </message>
        <message>
            <source>Figures</source>
            <translation>Figures</translation>
        </message>
        <message>
            <source>Serial number of part %1</source>
            <translation>Serial number of part %1</translation>
        </message>
        <message>
            <source>Type it or read it with a scanner.</source>
            <translation>Type it or read it with a scanner.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>The serial number is stored.</source>
            <translation>The serial number is stored.</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Save</translation>
        </message>
        <message>
            <source>Report of part %1</source>
            <translation>Report of part %1</translation>
        </message>
        <message>
            <source>One page as PDF, or its measurements as CSV.</source>
            <translation>One page as PDF, or its measurements as CSV.</translation>
        </message>
        <message>
            <source>CSV</source>
            <translation>CSV</translation>
        </message>
        <message>
            <source>PDF</source>
            <translation>PDF</translation>
        </message>
        <message>
            <source>Written: %1</source>
            <translation>Written: %1</translation>
        </message>
        <message>
            <source>Out of tolerance</source>
            <translation>Out of tolerance</translation>
        </message>
        <message>
            <source>All processes</source>
            <translation>All processes</translation>
        </message>
        <message>
            <source>%1 parts out of tolerance among the newest %2</source>
            <translation>%1 parts out of tolerance among the newest %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ProcessPanel</name>
        <message>
            <source>Cutting process</source>
            <translation>Cutting process</translation>
        </message>
        <message>
            <source>identified, 95 %</source>
            <translation>identified, 95 %</translation>
        </message>
        <message>
            <source>law</source>
            <translation>law</translation>
        </message>
        <message>
            <source>excitation %1: enough to learn from</source>
            <translation>excitation %1: enough to learn from</translation>
        </message>
        <message>
            <source>excitation %1: too little, the values rest</source>
            <translation>excitation %1: too little, the values rest</translation>
        </message>
        <message>
            <source>Identified only with a sensor of the tool's motion; the law assumes its values.</source>
            <translation>Identified only with a sensor of the tool's motion; the law assumes its values.</translation>
        </message>
        <message numerus="yes">
            <source>The law was tuned anew %n time(s): the process had moved.</source>
            <translation>
                <numerusform>The law was tuned anew %n time: the process had moved.</numerusform>
                <numerusform>The law was tuned anew %n times: the process had moved.</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::QualityPage</name>
        <message>
            <source>no part waits for a decision</source>
            <translation>no part waits for a decision</translation>
        </message>
        <message>
            <source>no lot is shown</source>
            <translation>no lot is shown</translation>
        </message>
        <message>
            <source>the recipe holds the limits of a bore</source>
            <translation>the recipe holds the limits of a bore</translation>
        </message>
        <message>
            <source>This console has no database, so there is no quality to show.</source>
            <translation>This console has no database, so there is no quality to show.</translation>
        </message>
        <message>
            <source>Decide</source>
            <translation>Decide</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>Gauges</translation>
        </message>
        <message>
            <source>Reports</source>
            <translation>Reports</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>Limits</translation>
        </message>
        <message>
            <source>Error against the law</source>
            <translation>Error against the law</translation>
        </message>
        <message>
            <source>Measured, with tolerance</source>
            <translation>Measured, with tolerance</translation>
        </message>
        <message>
            <source>What the controller does</source>
            <translation>What the controller does</translation>
        </message>
        <message>
            <source>Spread</source>
            <translation>Spread</translation>
        </message>
        <message>
            <source>%1: lot %2</source>
            <translation>%1: lot %2</translation>
        </message>
        <message>
            <source>%1: newest parts</source>
            <translation>%1: newest parts</translation>
        </message>
        <message>
            <source>The lot is being read.</source>
            <translation>The lot is being read.</translation>
        </message>
        <message>
            <source>Choose a lot.</source>
            <translation>Choose a lot.</translation>
        </message>
        <message>
            <source>%1 good, %2 rework possible, %3 scrap, %4 not judged</source>
            <translation>%1 good, %2 rework possible, %3 scrap, %4 not judged</translation>
        </message>
        <message>
            <source>The estimator takes σ %1 for the gauge: typed in the recipe, not from a study.</source>
            <translation>The estimator takes σ %1 for the gauge: typed in the recipe, not from a study.</translation>
        </message>
        <message>
            <source>The estimator takes σ %1 for the gauge, from the study of %2 (%3 to %4).</source>
            <translation>The estimator takes σ %1 for the gauge, from the study of %2 (%3 to %4).</translation>
        </message>
        <message>
            <source>Gauge %1 is %2.</source>
            <translation>Gauge %1 is %2.</translation>
        </message>
        <message>
            <source>Part %1 is out of tolerance: %2</source>
            <translation>Part %1 is out of tolerance: %2</translation>
        </message>
        <message>
            <source>What was done with it?</source>
            <translation>What was done with it?</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Not stored: %1</source>
            <translation>Not stored: %1</translation>
        </message>
        <message>
            <source>Cut again</source>
            <translation>Cut again</translation>
        </message>
        <message>
            <source>Scrapped</source>
            <translation>Scrapped</translation>
        </message>
        <message>
            <source>Accepted under concession</source>
            <translation>Accepted under concession</translation>
        </message>
        <message>
            <source>these are the first parts</source>
            <translation>these are the first parts</translation>
        </message>
        <message>
            <source>these are the newest parts</source>
            <translation>these are the newest parts</translation>
        </message>
        <message>
            <source>Older</source>
            <translation>Older</translation>
        </message>
        <message>
            <source>Newer</source>
            <translation>Newer</translation>
        </message>
        <message>
            <source>Older parts</source>
            <translation>Older parts</translation>
        </message>
        <message>
            <source>Newer parts</source>
            <translation>Newer parts</translation>
        </message>
        <message>
            <source>Parts of one tool, person or gauge</source>
            <translation>Parts of one tool, person or gauge</translation>
        </message>
        <message>
            <source>all parts</source>
            <translation>all parts</translation>
        </message>
        <message>
            <source>Parts %1 to %2: %3</source>
            <comment>of a lot that is larger than what is read at once</comment>
            <translation>Parts %1 to %2: %3</translation>
        </message>
        <message>
            <source>%1: all lots</source>
            <translation>%1: all lots</translation>
        </message>
        <message>
            <source>choose one lot</source>
            <translation>choose one lot</translation>
        </message>
        <message>
            <source>Rules</source>
            <translation>Rules</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::QualitySheets</name>
        <message>
            <source>Written: %1</source>
            <translation>Written: %1</translation>
        </message>
        <message>
            <source>Nothing written: %1</source>
            <translation>Nothing written: %1</translation>
        </message>
        <message>
            <source>Report and files of the lot</source>
            <translation>Report and files of the lot</translation>
        </message>
        <message>
            <source>A report is a PDF with the values attached as Q-DAS file and CSV.</source>
            <translation>A report is a PDF with the values attached as Q-DAS file and CSV.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>Lot report</source>
            <translation>Lot report</translation>
        </message>
        <message>
            <source>First article</source>
            <translation>First article</translation>
        </message>
        <message>
            <source>Q-DAS file</source>
            <translation>Q-DAS file</translation>
        </message>
        <message>
            <source>Automatic files</source>
            <translation>Automatic files</translation>
        </message>
        <message>
            <source>Q-DAS files by themselves</source>
            <translation>Q-DAS files by themselves</translation>
        </message>
        <message>
            <source>Each part gets a file in this folder once it is judged. Without a folder there are no files. Names may hold {type}, {lot}, {part}, {serial}, {machine}, {date} and {time}.</source>
            <translation>Each part gets a file in this folder once it is judged. Without a folder there are no files. Names may hold {type}, {lot}, {part}, {serial}, {machine}, {date} and {time}.</translation>
        </message>
        <message>
            <source>Folder</source>
            <translation>Folder</translation>
        </message>
        <message>
            <source>File name</source>
            <translation>File name</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Save</translation>
        </message>
        <message>
            <source>Rules of the charts</source>
            <translation>Rules of the charts</translation>
        </message>
        <message>
            <source>What a rule finds becomes a signal and an alarm. Each one more alarms wrongly more often: Nelson 1 with the EWMA once in about 400 parts of a steady lot, all eight of Nelson once in about 100.</source>
            <translation>What a rule finds becomes a signal and an alarm. Each one more alarms wrongly more often: Nelson 1 with the EWMA once in about 400 parts of a steady lot, all eight of Nelson once in about 100.</translation>
        </message>
        <message>
            <source>Default set</source>
            <translation>Default set</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::RawChart</name>
        <message>
            <source>part</source>
            <translation>part</translation>
        </message>
        <message>
            <source>The measured values of the lot appear here.</source>
            <translation>The measured values of the lot appear here.</translation>
        </message>
        <message>
            <source>Measured values with their tolerance</source>
            <translation>Measured values with their tolerance</translation>
        </message>
        <message>
            <source>upper</source>
            <translation>upper</translation>
        </message>
        <message>
            <source>lower</source>
            <translation>lower</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::RecipeForm</name>
        <message>
            <source>at most %1 depths</source>
            <translation>at most %1 depths</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Remove</translation>
        </message>
        <message>
            <source>Depth %1, overhang</source>
            <translation>Depth %1, overhang</translation>
        </message>
        <message>
            <source>%1: %2 → %3</source>
            <comment>name of a number, newest revision, shown</comment>
            <translation>%1: %2 → %3</translation>
        </message>
        <message>
            <source>Depth %1</source>
            <translation>Depth %1</translation>
        </message>
        <message>
            <source>Against revision %1:</source>
            <translation>Against revision %1:</translation>
        </message>
        <message>
            <source>As revision %1, the newest.</source>
            <translation>As revision %1, the newest.</translation>
        </message>
        <message>
            <source>A number is missing or out of its range.</source>
            <translation>A number is missing or out of its range.</translation>
        </message>
        <message>
            <source>Lots that are open keep their own revision.</source>
            <translation>Lots that are open keep their own revision.</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>being stored</translation>
        </message>
        <message>
            <source>sign on first</source>
            <translation>sign on first</translation>
        </message>
        <message>
            <source>a number does not fit</source>
            <translation>a number does not fit</translation>
        </message>
        <message>
            <source>a part type needs a name</source>
            <translation>a part type needs a name</translation>
        </message>
        <message>
            <source>nothing is changed</source>
            <translation>nothing is changed</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>give a reason</translation>
        </message>
        <message>
            <source>touch an older revision</source>
            <translation>touch an older revision</translation>
        </message>
        <message>
            <source>The recipe has a new revision.</source>
            <translation>The recipe has a new revision.</translation>
        </message>
        <message>
            <source>The part type is there.</source>
            <translation>The part type is there.</translation>
        </message>
        <message>
            <source>Revision %1 is back.</source>
            <translation>Revision %1 is back.</translation>
        </message>
        <message>
            <source>Recipe of %1</source>
            <translation>Recipe of %1</translation>
        </message>
        <message>
            <source>New part type</source>
            <translation>New part type</translation>
        </message>
        <message>
            <source>%1 to %2; default %3, %4</source>
            <comment>range, default, source of the default</comment>
            <translation>%1 to %2; default %3, %4</translation>
        </message>
        <message>
            <source>Name of the part type</source>
            <translation>Name of the part type</translation>
        </message>
        <message>
            <source>Reason for the change</source>
            <translation>Reason for the change</translation>
        </message>
        <message>
            <source>Depths, in measuring order</source>
            <translation>Depths, in measuring order</translation>
        </message>
        <message>
            <source>Add a depth</source>
            <translation>Add a depth</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Back</translation>
        </message>
        <message>
            <source>Roll back to it</source>
            <translation>Roll back to it</translation>
        </message>
        <message>
            <source>Save as a new revision</source>
            <translation>Save as a new revision</translation>
        </message>
        <message>
            <source>Make the part type</source>
            <translation>Make the part type</translation>
        </message>
        <message>
            <source>Rev.</source>
            <translation>Rev.</translation>
        </message>
        <message>
            <source>When, by</source>
            <translation>When, by</translation>
        </message>
        <message>
            <source>Why</source>
            <translation>Why</translation>
        </message>
        <message>
            <source>back to %1: %2</source>
            <comment>revision, reason</comment>
            <translation>back to %1: %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::RecoverySheet</name>
        <message>
            <source>the tap is turning out</source>
            <translation>the tap is turning out</translation>
        </message>
        <message>
            <source>the tap is out</source>
            <translation>the tap is out</translation>
        </message>
        <message>
            <source>switch tapping to control</source>
            <translation>switch tapping to control</translation>
        </message>
        <message>
            <source>A tap stands in the hole</source>
            <translation>A tap stands in the hole</translation>
        </message>
        <message>
            <source>Where: %1 revolutions in, %2 deep; the spindle stands %3° after a whole turn. Both are stored.</source>
            <translation>Where: %1 revolutions in, %2 deep; the spindle stands %3° after a whole turn. Both are stored.</translation>
        </message>
        <message>
            <source>What will happen: the accepted gains are set, then the spindle turns back %1 revolutions and Z follows it at %2 per revolution until the tap is out. No other axis moves. Do not jog Z or the spindle alone: it breaks the tap.</source>
            <translation>What will happen: the accepted gains are set, then the spindle turns back %1 revolutions and Z follows it at %2 per revolution until the tap is out. No other axis moves. Do not jog Z or the spindle alone: it breaks the tap.</translation>
        </message>
        <message>
            <source>Ready. Keep a hand at the emergency stop.</source>
            <translation>Ready. Keep a hand at the emergency stop.</translation>
        </message>
        <message>
            <source>Not ready: %1.</source>
            <translation>Not ready: %1.</translation>
        </message>
        <message>
            <source>Turning out: %1 revolutions to go.</source>
            <translation>Turning out: %1 revolutions to go.</translation>
        </message>
        <message>
            <source>The tap is out. Gauge the thread and look at the tap before the next one.</source>
            <translation>The tap is out. Gauge the thread and look at the tap before the next one.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>Leave it in the hole</source>
            <translation>Leave it in the hole</translation>
        </message>
        <message>
            <source>Turn out in sync</source>
            <translation>Turn out in sync</translation>
        </message>
        <message>
            <source>The tap is gone</source>
            <translation>The tap is gone</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ResidualChart</name>
        <message>
            <source>part</source>
            <translation>part</translation>
        </message>
        <message>
            <source>error against the law, σ</source>
            <translation>error against the law, σ</translation>
        </message>
        <message>
            <source>The error of each part against the law's prediction appears here from the second part on.</source>
            <translation>The error of each part against the law's prediction appears here from the second part on.</translation>
        </message>
        <message>
            <source>EWMA</source>
            <translation>EWMA</translation>
        </message>
        <message>
            <source>One-step errors</source>
            <translation>One-step errors</translation>
        </message>
        <message>
            <source>signal</source>
            <translation>signal</translation>
        </message>
        <message>
            <source>EWMA limit</source>
            <translation>EWMA limit</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SensorsPage</name>
        <message>
            <source>touch a channel first</source>
            <translation>touch a channel first</translation>
        </message>
        <message>
            <source>no gauge that can be asked is connected</source>
            <translation>no gauge that can be asked is connected</translation>
        </message>
        <message>
            <source>This console was started without a sensor file (--sensors): only what the machine itself brings is read.</source>
            <translation>This console was started without a sensor file (--sensors): only what the machine itself brings is read.</translation>
        </message>
        <message>
            <source>Sensors and gauges</source>
            <translation>Sensors and gauges</translation>
        </message>
        <message>
            <source>Where they sit</source>
            <translation>Where they sit</translation>
        </message>
        <message>
            <source>Channel</source>
            <translation>Channel</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>Place</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Value</translation>
        </message>
        <message>
            <source>Age</source>
            <translation>Age</translation>
        </message>
        <message>
            <source>State</source>
            <translation>State</translation>
        </message>
        <message>
            <source>Module, gauge</source>
            <translation>Module, gauge</translation>
        </message>
        <message>
            <source>Address</source>
            <translation>Address</translation>
        </message>
        <message>
            <source>Reads</source>
            <translation>Reads</translation>
        </message>
        <message>
            <source>Place on the picture</source>
            <translation>Place on the picture</translation>
        </message>
        <message>
            <source>Test read of the gauges</source>
            <translation>Test read of the gauges</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>good</source>
            <translation>good</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 of %2</translation>
        </message>
        <message>
            <source>not plugged in</source>
            <translation>not plugged in</translation>
        </message>
        <message>
            <source>connected</source>
            <translation>connected</translation>
        </message>
        <message>
            <source>Stop looking</source>
            <translation>Stop looking</translation>
        </message>
        <message>
            <source>Which one rises?</source>
            <translation>Which one rises?</translation>
        </message>
        <message>
            <source>The reading process does not answer; it is started again.</source>
            <translation>The reading process does not answer; it is started again.</translation>
        </message>
        <message>
            <source>Touch the picture where %1 sits.</source>
            <translation>Touch the picture where %1 sits.</translation>
        </message>
        <message>
            <source>It is %1: %2 warmer.</source>
            <translation>It is %1: %2 warmer.</translation>
        </message>
        <message>
            <source>Warm one thermocouple with a finger; its channel shows itself.</source>
            <translation>Warm one thermocouple with a finger; its channel shows itself.</translation>
        </message>
        <message>
            <source>A picture of this machine (PNG) in %1 is shown here.</source>
            <translation>A picture of this machine (PNG) in %1 is shown here.</translation>
        </message>
        <message>
            <source>Touch a channel, then its place on the picture.</source>
            <translation>Touch a channel, then its place on the picture.</translation>
        </message>
        <message>
            <source>Sensor file and modules</source>
            <translation>Sensor file and modules</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>%1: no reading</source>
            <translation>%1: no reading</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::Sheet</name>
        <message>
            <source>That is stored. What was typed since then is not yet.</source>
            <translation>That is stored. What was typed since then is not yet.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SheetHost</name>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ShiftPage</name>
        <message>
            <source>this shift has been handed over</source>
            <translation>this shift has been handed over</translation>
        </message>
        <message>
            <source>No data file is open: a shift is what is stored between two handovers.</source>
            <translation>No data file is open: a shift is what is stored between two handovers.</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Parts</translation>
        </message>
        <message>
            <source>Stops: touch one and say why</source>
            <translation>Stops: touch one and say why</translation>
        </message>
        <message>
            <source>Notes and handover</source>
            <translation>Notes and handover</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>Changes</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>Alarms</translation>
        </message>
        <message>
            <source>◀ Shift before</source>
            <translation>◀ Shift before</translation>
        </message>
        <message>
            <source>This shift</source>
            <translation>This shift</translation>
        </message>
        <message>
            <source>One page (PDF)</source>
            <translation>One page (PDF)</translation>
        </message>
        <message>
            <source>Leave a note</source>
            <translation>Leave a note</translation>
        </message>
        <message>
            <source>Hand over</source>
            <translation>Hand over</translation>
        </message>
        <message>
            <source>Shift from %1 to %2</source>
            <translation>Shift from %1 to %2</translation>
        </message>
        <message>
            <source>The last twelve hours; a shift begins when one is handed over.</source>
            <translation>The last twelve hours; a shift begins when one is handed over.</translation>
        </message>
        <message>
            <source>This shift, taken over from %2 at %1</source>
            <translation>This shift, taken over from %2 at %1</translation>
        </message>
        <message>
            <source>No part was finished.</source>
            <translation>No part was finished.</translation>
        </message>
        <message>
            <source>since %1</source>
            <translation>since %1</translation>
        </message>
        <message>
            <source>%1 min</source>
            <translation>%1 min</translation>
        </message>
        <message>
            <source>Nothing stood longer than three minutes.</source>
            <translation>Nothing stood longer than three minutes.</translation>
        </message>
        <message>
            <source>Handover: %1</source>
            <translation>Handover: %1</translation>
        </message>
        <message>
            <source>No note was left.</source>
            <translation>No note was left.</translation>
        </message>
        <message>
            <source>Nothing was changed.</source>
            <translation>Nothing was changed.</translation>
        </message>
        <message>
            <source>No alarm came.</source>
            <translation>No alarm came.</translation>
        </message>
        <message>
            <source>Why did nothing run?</source>
            <translation>Why did nothing run?</translation>
        </message>
        <message>
            <source>The reason is kept.</source>
            <translation>The reason is kept.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Hand over the shift</source>
            <translation>Hand over the shift</translation>
        </message>
        <message>
            <source>A note for the next shift</source>
            <translation>A note for the next shift</translation>
        </message>
        <message>
            <source>It is signed by %1. The next shift begins now.</source>
            <translation>It is signed by %1. The next shift begins now.</translation>
        </message>
        <message>
            <source>What the next one has to know</source>
            <translation>What the next one has to know</translation>
        </message>
        <message>
            <source>Sign and hand over</source>
            <translation>Sign and hand over</translation>
        </message>
        <message>
            <source>Keep the note</source>
            <translation>Keep the note</translation>
        </message>
        <message>
            <source>The shift is handed over.</source>
            <translation>The shift is handed over.</translation>
        </message>
        <message>
            <source>The note is kept.</source>
            <translation>The note is kept.</translation>
        </message>
        <message>
            <source>Where to</source>
            <translation>Where to</translation>
        </message>
        <message>
            <source>A file that is there already is never written over.</source>
            <translation>A file that is there already is never written over.</translation>
        </message>
        <message>
            <source>shift</source>
            <comment>file name</comment>
            <translation>shift</translation>
        </message>
        <message>
            <source>Written: %1</source>
            <translation>Written: %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SpectrumChart</name>
        <message>
            <source>amplitude</source>
            <translation>amplitude</translation>
        </message>
        <message>
            <source>without the trim</source>
            <translation>without the trim</translation>
        </message>
        <message>
            <source>predicted surface</source>
            <translation>predicted surface</translation>
        </message>
        <message>
            <source>The spectrum of the surface appears here after two seconds of cutting.</source>
            <translation>The spectrum of the surface appears here after two seconds of cutting.</translation>
        </message>
        <message>
            <source>Spectrum of the predicted surface</source>
            <translation>Spectrum of the predicted surface</translation>
        </message>
        <message>
            <source>amplitude, %1, over frequency, Hz</source>
            <comment>unit</comment>
            <translation>amplitude, %1, over frequency, Hz</translation>
        </message>
        <message>
            <source>%1 blind</source>
            <comment>frequency in Hz</comment>
            <translation>%1 blind</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SpeedChart</name>
        <message>
            <source>error p-p</source>
            <translation>error p-p</translation>
        </message>
        <message>
            <source>Each speed that has been tuned stands here as a point: error against time per hole.</source>
            <translation>Each speed that has been tuned stands here as a point: error against time per hole.</translation>
        </message>
        <message>
            <source>Sync error against time per hole, by speed</source>
            <translation>Sync error against time per hole, by speed</translation>
        </message>
        <message>
            <source>allowed</source>
            <translation>allowed</translation>
        </message>
        <message>
            <source>%1 rpm</source>
            <translation>%1 rpm</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SpreadChart</name>
        <message>
            <source>parts</source>
            <translation>parts</translation>
        </message>
        <message>
            <source>How the values lie in their tolerance appears here.</source>
            <translation>How the values lie in their tolerance appears here.</translation>
        </message>
        <message>
            <source>Histogram with tolerance</source>
            <translation>Histogram with tolerance</translation>
        </message>
        <message>
            <source>lower</source>
            <translation>lower</translation>
        </message>
        <message>
            <source>upper</source>
            <translation>upper</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SurfacePanel</name>
        <message>
            <source>Surface as the force shows it</source>
            <translation>Surface as the force shows it</translation>
        </message>
        <message>
            <source>No tone of this machine is known.</source>
            <translation>No tone of this machine is known.</translation>
        </message>
        <message>
            <source>At %1 the force sees every known tone.</source>
            <translation>At %1 the force sees every known tone.</translation>
        </message>
        <message>
            <source>At %1 the force is blind to %2 Hz: such a tone repeats with every revolution.</source>
            <translation>At %1 the force is blind to %2 Hz: such a tone repeats with every revolution.</translation>
        </message>
        <message>
            <source>Use %1</source>
            <translation>Use %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TapActions</name>
        <message>
            <source>a tuning is under way</source>
            <translation>a tuning is under way</translation>
        </message>
        <message>
            <source>nothing to accept</source>
            <translation>nothing to accept</translation>
        </message>
        <message>
            <source>Job…</source>
            <translation>Job…</translation>
        </message>
        <message>
            <source>Tune</source>
            <translation>Tune</translation>
        </message>
        <message>
            <source>One more</source>
            <translation>One more</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Accept</translation>
        </message>
        <message>
            <source>Roll back</source>
            <translation>Roll back</translation>
        </message>
        <message>
            <source>Automatic</source>
            <translation>Automatic</translation>
        </message>
        <message>
            <source>Abort the tap</source>
            <translation>Abort the tap</translation>
        </message>
        <message>
            <source>Turn the tap out…</source>
            <translation>Turn the tap out…</translation>
        </message>
        <message>
            <source>No job is loaded</source>
            <translation>No job is loaded</translation>
        </message>
        <message>
            <source>Tap</source>
            <translation>Tap</translation>
        </message>
        <message>
            <source>Air tap</source>
            <translation>Air tap</translation>
        </message>
        <message>
            <source>a tap stands in the hole</source>
            <translation>a tap stands in the hole</translation>
        </message>
        <message>
            <source>a tap is under way</source>
            <translation>a tap is under way</translation>
        </message>
        <message>
            <source>this machine has no tapping loop</source>
            <translation>this machine has no tapping loop</translation>
        </message>
        <message>
            <source>switch to control</source>
            <translation>switch to control</translation>
        </message>
        <message>
            <source>no job is loaded</source>
            <translation>no job is loaded</translation>
        </message>
        <message>
            <source>no proposal yet</source>
            <translation>no proposal yet</translation>
        </message>
        <message>
            <source>all taps are used</source>
            <translation>all taps are used</translation>
        </message>
        <message>
            <source>nothing to roll back</source>
            <translation>nothing to roll back</translation>
        </message>
        <message>
            <source>the tap is being turned out</source>
            <translation>the tap is being turned out</translation>
        </message>
        <message>
            <source>no tap is running</source>
            <translation>no tap is running</translation>
        </message>
        <message>
            <source>the loop is off: abort at the control</source>
            <translation>the loop is off: abort at the control</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TappingPage</name>
        <message>
            <source>Load this point?</source>
            <translation>Load this point?</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancel</translation>
        </message>
        <message>
            <source>Load</source>
            <translation>Load</translation>
        </message>
        <message>
            <source>This machine does not tap with Kerf. The page fills when its tapping loop is fitted.</source>
            <translation>This machine does not tap with Kerf. The page fills when its tapping loop is fitted.</translation>
        </message>
        <message>
            <source>Trial taps</source>
            <translation>Trial taps</translation>
        </message>
        <message>
            <source>Error p-p, %1, over time per hole</source>
            <comment>unit</comment>
            <translation>Error p-p, %1, over time per hole</translation>
        </message>
        <message>
            <source>%1 rev, error %2</source>
            <translation>%1 rev, error %2</translation>
        </message>
        <message>
            <source>A tap stands %1 revolutions (%2) in the hole. Turn it out in sync before anything else moves.</source>
            <translation>A tap stands %1 revolutions (%2) in the hole. Turn it out in sync before anything else moves.</translation>
        </message>
        <message>
            <source>No tap was made: %1</source>
            <translation>No tap was made: %1</translation>
        </message>
        <message>
            <source>The tuning could not be stored: %1</source>
            <translation>The tuning could not be stored: %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ThermalPage</name>
        <message>
            <source>This machine reports no temperatures. The page fills as soon as it does.</source>
            <translation>This machine reports no temperatures. The page fills as soon as it does.</translation>
        </message>
        <message>
            <source>Drift over time, %1</source>
            <translation>Drift over time, %1</translation>
        </message>
        <message>
            <source>The predicted drift appears here one minute after the reference, as soon as a model is live.</source>
            <translation>The predicted drift appears here one minute after the reference, as soon as a model is live.</translation>
        </message>
        <message>
            <source>Temperatures</source>
            <translation>Temperatures</translation>
        </message>
        <message>
            <source>Warm up</source>
            <translation>Warm up</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>Measure</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>Model</translation>
        </message>
        <message>
            <source>History</source>
            <translation>History</translation>
        </message>
        <message>
            <source>Sensors</source>
            <translation>Sensors</translation>
        </message>
        <message>
            <source>Error map</source>
            <translation>Error map</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>Limits</translation>
        </message>
        <message>
            <source>Stop warm-up</source>
            <translation>Stop warm-up</translation>
        </message>
        <message>
            <source>Nothing can be stored at the moment: %1</source>
            <translation>Nothing can be stored at the moment: %1</translation>
        </message>
        <message>
            <source>No temperatures yet.</source>
            <translation>No temperatures yet.</translation>
        </message>
        <message numerus="yes">
            <source>%n thermocouples give no reading.</source>
            <translation>
                <numerusform>%n thermocouple gives no reading.</numerusform>
                <numerusform>%n thermocouples give no reading.</numerusform>
            </translation>
        </message>
        <message>
            <source>Left out: %1</source>
            <translation>Left out: %1</translation>
        </message>
        <message>
            <source>All %1 thermocouples are healthy; filled points belong to the model.</source>
            <translation>All %1 thermocouples are healthy; filled points belong to the model.</translation>
        </message>
        <message>
            <source>Touch a point to read it.</source>
            <translation>Touch a point to read it.</translation>
        </message>
        <message>
            <source>%1: %2, %3; %4 in 10 min</source>
            <comment>sensor, temperature, state, change</comment>
            <translation>%1: %2, %3; %4 in 10 min</translation>
        </message>
        <message>
            <source>Warm up the spindle?</source>
            <translation>Warm up the spindle?</translation>
        </message>
        <message>
            <source>The spindle turns at %1 for %2. Take care that nothing is in its way.</source>
            <translation>The spindle turns at %1 for %2. Take care that nothing is in its way.</translation>
        </message>
        <message>
            <source>Not now</source>
            <translation>Not now</translation>
        </message>
        <message>
            <source>Start the spindle</source>
            <translation>Start the spindle</translation>
        </message>
        <message>
            <source>time</source>
            <translation>time</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TouchKeyboard</name>
        <message>
            <source>ABC</source>
            <translation>ABC</translation>
        </message>
        <message>
            <source>Space</source>
            <translation>Space</translation>
        </message>
        <message>
            <source>Enter</source>
            <translation>Enter</translation>
        </message>
        <message>
            <source>Hide the keyboard</source>
            <translation>Hide the keyboard</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TrialBars</name>
        <message>
            <source>before</source>
            <translation>before</translation>
        </message>
        <message>
            <source>after</source>
            <translation>after</translation>
        </message>
        <message>
            <source>One bar per trial tap appears here.</source>
            <translation>One bar per trial tap appears here.</translation>
        </message>
        <message>
            <source>allowed %1</source>
            <translation>allowed %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TurningArchive</name>
        <message>
            <source>Archive of turned parts</source>
            <translation>Archive of turned parts</translation>
        </message>
        <message>
            <source>Touch a part to see its spectrum and its force along the face.</source>
            <translation>Touch a part to see its spectrum and its force along the face.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>force, %1, along the face, %</source>
            <comment>unit</comment>
            <translation>force, %1, along the face, %</translation>
        </message>
        <message>
            <source>force</source>
            <translation>force</translation>
        </message>
        <message>
            <source>This part has no force trace.</source>
            <translation>This part has no force trace.</translation>
        </message>
        <message>
            <source>Force along the face</source>
            <translation>Force along the face</translation>
        </message>
        <message>
            <source>part</source>
            <translation>part</translation>
        </message>
        <message>
            <source>ended</source>
            <translation>ended</translation>
        </message>
        <message>
            <source>controller</source>
            <translation>controller</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>P-V</source>
            <translation>P-V</translation>
        </message>
        <message>
            <source>open</source>
            <comment>surface without the trim</comment>
            <translation>open</translation>
        </message>
        <message>
            <source>mean force</source>
            <translation>mean force</translation>
        </message>
        <message>
            <source>left the loop</source>
            <translation>left the loop</translation>
        </message>
        <message>
            <source>no control</source>
            <translation>no control</translation>
        </message>
        <message>
            <source>Part %1: %2. Touched at %3, zero %4, largest trim %5.</source>
            <translation>Part %1: %2. Touched at %3, zero %4, largest trim %5.</translation>
        </message>
        <message>
            <source>a₁ %1, b₀ %2, b₁ %3.</source>
            <translation>a₁ %1, b₀ %2, b₁ %3.</translation>
        </message>
        <message>
            <source>It was not cut to the end.</source>
            <translation>It was not cut to the end.</translation>
        </message>
        <message>
            <source>target</source>
            <translation>target</translation>
        </message>
        <message>
            <source>Reason to leave this part out of what the next ones begin from</source>
            <translation>Reason to leave this part out of what the next ones begin from</translation>
        </message>
        <message>
            <source>Left out by %1: %2</source>
            <translation>Left out by %1: %2</translation>
        </message>
        <message>
            <source>The first part after a start begins from the assumed process: none of this cut is sure.</source>
            <translation>The first part after a start begins from the assumed process: none of this cut is sure.</translation>
        </message>
        <message>
            <source>The first part after a start begins from part %1; parts of this cut that count: %2.</source>
            <translation>The first part after a start begins from part %1; parts of this cut that count: %2.</translation>
        </message>
        <message>
            <source>The first part after a start begins from the assumed process: the parts of this cut contradict each other.</source>
            <translation>The first part after a start begins from the assumed process: the parts of this cut contradict each other.</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>Take in again</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>Leave out</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TurningControlPanel</name>
        <message>
            <source>controller</source>
            <translation>controller</translation>
        </message>
        <message>
            <source>Start part</source>
            <translation>Start part</translation>
        </message>
        <message>
            <source>Setup</source>
            <translation>Setup</translation>
        </message>
        <message>
            <source>Next part: %1. Overlap factor %2.</source>
            <translation>Next part: %1. Overlap factor %2.</translation>
        </message>
        <message>
            <source>Nothing can be stored at the moment: %1</source>
            <translation>Nothing can be stored at the moment: %1</translation>
        </message>
        <message>
            <source>Diamond turning: %1</source>
            <comment>stage</comment>
            <translation>Diamond turning: %1</translation>
        </message>
        <message>
            <source>This machine has no turning loop: %1</source>
            <translation>This machine has no turning loop: %1</translation>
        </message>
        <message>
            <source>This machine has no turning loop.</source>
            <translation>This machine has no turning loop.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TurningPage</name>
        <message>
            <source>This machine has no turning loop: force feedback needs a lathe with a 0.2 ms cycle, a force sensor and a fast tool trim.</source>
            <translation>This machine has no turning loop: force feedback needs a lathe with a 0.2 ms cycle, a force sensor and a fast tool trim.</translation>
        </message>
        <message>
            <source>Predicted surface, RMS</source>
            <translation>Predicted surface, RMS</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TurningSetupForm</name>
        <message>
            <source>Setup of the next part</source>
            <translation>Setup of the next part</translation>
        </message>
        <message>
            <source>A part being cut keeps the setup it began with.</source>
            <translation>A part being cut keeps the setup it began with.</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>Cut</translation>
        </message>
        <message>
            <source>Tones of the machine</source>
            <translation>Tones of the machine</translation>
        </message>
        <message>
            <source>Leave as it is</source>
            <translation>Leave as it is</translation>
        </message>
        <message>
            <source>Use for the next part</source>
            <translation>Use for the next part</translation>
        </message>
        <message>
            <source>Tone %1</source>
            <translation>Tone %1</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>being stored</translation>
        </message>
        <message>
            <source>a value is missing</source>
            <translation>a value is missing</translation>
        </message>
        <message>
            <source>a tone is out of range</source>
            <translation>a tone is out of range</translation>
        </message>
        <message>
            <source>Overlap factor %1</source>
            <translation>Overlap factor %1</translation>
        </message>
        <message>
            <source>Not stored: %1</source>
            <translation>Not stored: %1</translation>
        </message>
        <message>
            <source>The next part is cut with the new setup.</source>
            <translation>The next part is cut with the new setup.</translation>
        </message>
        <message>
            <source>Reason, when a limit is raised</source>
            <translation>Reason, when a limit is raised</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ValueField</name>
        <message>
            <source>Enter a number.</source>
            <translation>Enter a number.</translation>
        </message>
        <message>
            <source>“%1” is not a number.</source>
            <translation>“%1” is not a number.</translation>
        </message>
        <message>
            <source>Must be from %1 to %2.</source>
            <translation>Must be from %1 to %2.</translation>
        </message>
    </context>
<context>
    <name>kerf::ui::SensorSetupPanel</name>
        <message>
            <source>none is chosen</source>
            <translation>none is chosen</translation>
        </message>
        <message>
            <source>being asked: units 1 to 32</source>
            <translation>being asked: units 1 to 32</translation>
        </message>
        <message>
            <source>enter its address first</source>
            <translation>enter its address first</translation>
        </message>
        <message>
            <source>Sensor file</source>
            <translation>Sensor file</translation>
        </message>
        <message>
            <source>What answers at an address</source>
            <translation>What answers at an address</translation>
        </message>
        <message>
            <source>Address of a temperature module (Modbus TCP), with its port where that is not 502. It is only read. What a module has in its registers says which channel is which.</source>
            <translation>Address of a temperature module (Modbus TCP), with its port where that is not 502. It is only read. What a module has in its registers says which channel is which.</translation>
        </message>
        <message>
            <source>Use this file from the next start</source>
            <translation>Use this file from the next start</translation>
        </message>
        <message>
            <source>Use none</source>
            <translation>Use none</translation>
        </message>
        <message>
            <source>Look again</source>
            <translation>Look again</translation>
        </message>
        <message>
            <source>Ask what is there</source>
            <translation>Ask what is there</translation>
        </message>
        <message>
            <source>File</source>
            <translation>File</translation>
        </message>
        <message>
            <source>What is in it</source>
            <translation>What is in it</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Unit</translation>
        </message>
        <message>
            <source>Module</source>
            <translation>Module</translation>
        </message>
        <message>
            <source>First registers</source>
            <translation>First registers</translation>
        </message>
        <message>
            <source>In use: %1. It was named at the start (--sensors), so it stays.</source>
            <translation>In use: %1. It was named at the start (--sensors), so it stays.</translation>
        </message>
        <message>
            <source>In use: %1.</source>
            <translation>In use: %1.</translation>
        </message>
        <message>
            <source>In use: %1. From the next start none is used.</source>
            <translation>In use: %1. From the next start none is used.</translation>
        </message>
        <message>
            <source>In use: %1. From the next start: %2.</source>
            <translation>In use: %1. From the next start: %2.</translation>
        </message>
        <message>
            <source>From the next start: %1. Until then only what the machine itself brings is read.</source>
            <translation>From the next start: %1. Until then only what the machine itself brings is read.</translation>
        </message>
        <message>
            <source>None is in use: only what the machine itself brings is read.</source>
            <translation>None is in use: only what the machine itself brings is read.</translation>
        </message>
        <message>
            <source>modules: %1, channels: %2, gauges: %3</source>
            <translation>modules: %1, channels: %2, gauges: %3</translation>
        </message>
        <message>
            <source>cannot be used: %1</source>
            <translation>cannot be used: %1</translation>
        </message>
        <message>
            <source>%1 is asked; that takes up to 20 s.</source>
            <translation>%1 is asked; that takes up to 20 s.</translation>
        </message>
        <message>
            <source>%1 takes a connection, but no unit from 1 to 32 answers.</source>
            <translation>%1 takes a connection, but no unit from 1 to 32 answers.</translation>
        </message>
        <message>
            <source>%1 answers; register numbers are as on the wire, from 0.</source>
            <translation>%1 answers; register numbers are as on the wire, from 0.</translation>
        </message>
        <message>
            <source>no sensor file is there yet</source>
            <translation>no sensor file is there yet</translation>
        </message>
        <message>
            <source>touch a file first</source>
            <translation>touch a file first</translation>
        </message>
        <message>
            <source>this one cannot be used</source>
            <translation>this one cannot be used</translation>
        </message>
        <message>
            <source>it is chosen already</source>
            <translation>it is chosen already</translation>
        </message>
        <message>
            <source>A sensor file (JSON) says which temperature modules and gauges hang on this machine: where each channel sits, its register, its scale. Put it into %1; docs/sensors.md has every key and an example.</source>
            <translation>A sensor file (JSON) says which temperature modules and gauges hang on this machine: where each channel sits, its register, its scale. Put it into %1; docs/sensors.md has every key and an example.</translation>
        </message>
    </context>
</TS>
