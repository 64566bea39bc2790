<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>QObject</name>
    <message numerus="yes">
        <source>mean error of %n building(s)</source>
        <translation>
            <numerusform>mean error of %n building</numerusform>
            <numerusform>mean error of %n buildings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TimeLeft</name>
    <message numerus="yes">
        <source>, about %n second(s) left</source>
        <translation>
            <numerusform>, about %n second left</numerusform>
            <numerusform>, about %n seconds left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, about %n minute(s) left</source>
        <translation>
            <numerusform>, about %n minute left</numerusform>
            <numerusform>, about %n minutes left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::BagDialog</name>
    <message numerus="yes">
        <source>%1 (%n message(s))</source>
        <translation>
            <numerusform>%1 (%n message)</numerusform>
            <numerusform>%1 (%n messages)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::CameraPanel</name>
    <message numerus="yes">
        <source> · %n window(s) placed the wall</source>
        <translation>
            <numerusform> · %n window placed the wall</numerusform>
            <numerusform> · %n windows placed the wall</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::CompareActions</name>
    <message numerus="yes">
        <source>The drawing and %1 have too little in common: %n building(s) or landmark(s), and three are needed.</source>
        <translation>
            <numerusform>The drawing and %1 have too little in common: %n building or landmark, and three are needed.</numerusform>
            <numerusform>The drawing and %1 have too little in common: %n buildings or landmarks, and three are needed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::FileActions</name>
    <message numerus="yes">
        <source>%n building(s) of “%1” are a new drawing now, and where they lie on earth is kept.</source>
        <translation>
            <numerusform>%n building of “%1” is a new drawing now, and where it lies on earth is kept.</numerusform>
            <numerusform>%n buildings of “%1” are a new drawing now, and where they lie on earth is kept.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n outline(s) were left out: they cross themselves or are too large.</source>
        <translation>
            <numerusform>%n outline was left out: it crosses itself or is too large.</numerusform>
            <numerusform>%n outlines were left out: they cross themselves or are too large.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::ImportDialog</name>
    <message numerus="yes">
        <source>%n scan(s)</source>
        <translation>
            <numerusform>%n scan</numerusform>
            <numerusform>%n scans</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pose(s)</source>
        <translation>
            <numerusform>%n pose</numerusform>
            <numerusform>%n poses</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::IssuesPanel</name>
    <message numerus="yes">
        <source>%n issue(s); a click shows where.</source>
        <translation>
            <numerusform>%n issue; a click shows where.</numerusform>
            <numerusform>%n issues; a click shows where.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::LiveWatch</name>
    <message numerus="yes">
        <source>The program ended in the middle of a drive. Its recording is whole, up to its last observation: %n of them.</source>
        <translation>
            <numerusform>The program ended in the middle of a drive. Its recording is whole, up to its last observation: %n of them.</numerusform>
            <numerusform>The program ended in the middle of a drive. Its recording is whole, up to its last observation: %n of them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::LogKeeper</name>
    <message numerus="yes">
        <source>The run begins: %1, %n building(s) drawn</source>
        <translation>
            <numerusform>The run begins: %1, %n building drawn</numerusform>
            <numerusform>The run begins: %1, %n buildings drawn</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A loop was closed; %n so far</source>
        <translation>
            <numerusform>A loop was closed; %n so far</numerusform>
            <numerusform>A loop was closed; %n so far</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::MessageBar</name>
    <message numerus="yes">
        <source>%n earlier message(s)</source>
        <translation>
            <numerusform>%n earlier message</numerusform>
            <numerusform>%n earlier messages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::PaperActions</name>
    <message numerus="yes">
        <source>%n closed shape(s) are found.</source>
        <translation>
            <numerusform>%n closed shape is found.</numerusform>
            <numerusform>%n closed shapes are found.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) are taken over; the page lies under the drawing.</source>
        <translation>
            <numerusform>%n building is taken over; the page lies under the drawing.</numerusform>
            <numerusform>%n buildings are taken over; the page lies under the drawing.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::PaperTool</name>
    <message numerus="yes">
        <source>Click a shape to take or leave it · Tab and Del do so by keys · Enter: take the %n ticked · Esc: none</source>
        <translation>
            <numerusform>Click a shape to take or leave it · Tab and Del do so by keys · Enter: take the %n ticked · Esc: none</numerusform>
            <numerusform>Click a shape to take or leave it · Tab and Del do so by keys · Enter: take the %n ticked · Esc: none</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::PhaseWords</name>
    <message numerus="yes">
        <source>Samples of %n building(s) in sight, before they move; score %1.</source>
        <translation>
            <numerusform>Samples of %n building in sight, before they move; score %1.</numerusform>
            <numerusform>Samples of %n buildings in sight, before they move; score %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) of the map moved by up to %1 m.</source>
        <translation>
            <numerusform>%n building of the map moved by up to %1 m.</numerusform>
            <numerusform>%n buildings of the map moved by up to %1 m.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::ResultActions</name>
    <message numerus="yes">
        <source>%n building(s) were edited since the run began: %1</source>
        <translation>
            <numerusform>%n building was edited since the run began: %1</numerusform>
            <numerusform>%n buildings were edited since the run began: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; and %n more</source>
        <translation>
            <numerusform>; and %n more</numerusform>
            <numerusform>; and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::RevisionActions</name>
    <message numerus="yes">
        <source>%n building(s) move by up to %1 m; %2.</source>
        <translation>
            <numerusform>%n building moves by up to %1 m; %2.</numerusform>
            <numerusform>%n buildings move by up to %1 m; %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::SourceActions</name>
    <message numerus="yes">
        <source>“%1” is open: %n frame(s).</source>
        <translation>
            <numerusform>“%1” is open: %n frame.</numerusform>
            <numerusform>“%1” is open: %n frames.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>On that drive somebody said %n thing(s): where the robot was, or which building is right or not there. The run does it again.</source>
        <translation>
            <numerusform>On that drive somebody said %n thing: where the robot was, or which building is right or not there. The run does it again.</numerusform>
            <numerusform>On that drive somebody said %n things: where the robot was, or which building is right or not there. The run does it again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The next run goes through %n given pose(s).</source>
        <translation>
            <numerusform>The next run goes through %n given pose.</numerusform>
            <numerusform>The next run goes through %n given poses.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::WhyPanel</name>
    <message numerus="yes">
        <source>Seen: %1 ±%2 m, weight %3 %, by %n observation(s)</source>
        <translation>
            <numerusform>Seen: %1 ±%2 m, weight %3 %, by %n observation</numerusform>
            <numerusform>Seen: %1 ±%2 m, weight %3 %, by %n observations</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::Words</name>
    <message numerus="yes">
        <source>%n building(s) moved by %1</source>
        <translation>
            <numerusform>%n building moved by %1</numerusform>
            <numerusform>%n buildings moved by %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stand(s) as drawn</source>
        <translation>
            <numerusform>%n stands as drawn</numerusform>
            <numerusform>%n stand as drawn</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n was (were) not recognised</source>
        <translation>
            <numerusform>%n was not recognised</numerusform>
            <numerusform>%n were not recognised</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n is (are) doubtful: look at %1.</source>
        <translation>
            <numerusform>%n is doubtful: look at %1.</numerusform>
            <numerusform>%n are doubtful: look at %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For: seen in %n observation(s)</source>
        <translation>
            <numerusform>For: seen in %n observation</numerusform>
            <numerusform>For: seen in %n observations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turned by up to %1</source>
        <translation>
            <numerusform>%n turned by %1</numerusform>
            <numerusform>%n turned by up to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n grown or shrunk by up to %1 m</source>
        <translation>
            <numerusform>%n grown or shrunk by %1 m</numerusform>
            <numerusform>%n grown or shrunk by up to %1 m</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %n (%1) only one side was seen: how deep that is, is as drawn.</source>
        <translation>
            <numerusform>Of %n (%1) only one side was seen: how deep it is, is as drawn.</numerusform>
            <numerusform>Of %n (%1) only one side was seen: how deep they are, is as drawn.</numerusform>
        </translation>
    </message>
</context>
</TS>
