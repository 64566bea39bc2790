<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>QObject</name>
    <message numerus="yes">
        <source>mean error of %n building(s)</source>
        <translation><numerusform>mean error of %n building</numerusform><numerusform>mean error of %n buildings</numerusform></translation>
    </message>
</context>
<context>
    <name>handmap::IssuesPanel</name>
    <message numerus="yes">
        <source>%n issue(s); a click shows where.</source>
        <translation><numerusform>%n issue; a click shows where.</numerusform><numerusform>%n issues; a click shows where.</numerusform></translation>
    </message>
</context>
<context>
    <name>handmap::RevisionActions</name>
    <message numerus="yes">
        <source>%n building(s) move by up to %1 m; %2.</source>
        <translation><numerusform>%n building moves by up to %1 m; %2.</numerusform><numerusform>%n buildings move by up to %1 m; %2.</numerusform></translation>
    </message>
</context>
<context>
    <name>handmap::RunActions</name>
    <message numerus="yes">
        <source>“%1” is open: %n row(s).</source>
        <translation><numerusform>“%1” is open: %n row.</numerusform><numerusform>“%1” is open: %n rows.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) were edited since the run began: %1</source>
        <translation><numerusform>%n building was edited since the run began: %1</numerusform><numerusform>%n buildings were edited since the run began: %1</numerusform></translation>
    </message>
</context>
</TS>
