<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>MeshQuality</name>
    <message>
        <source>Show where</source>
        <translation>Zeigen, wo</translation>
    </message>
    <message>
        <source>Selects the faces of the part on which the mesh misses what was asked for</source>
        <translation>Wählt die Flächen des Teils aus, auf denen das Netz das Verlangte verfehlt</translation>
    </message>
    <message>
        <source>The mesh keeps all that was asked for.</source>
        <translation>Das Netz hält alles ein, was verlangt war.</translation>
    </message>
    <message>
        <source>What was asked for is missed: {}</source>
        <translation>Verlangtes ist verfehlt: {}</translation>
    </message>
    <message>
        <source>Update the mesh to learn whether it keeps what was asked for.</source>
        <translation>Erst nach einer Aktualisierung ist bekannt, ob das Netz das Verlangte einhält.</translation>
    </message>
    <message>
        <source>The mesh is out of date: a source or an option has changed.</source>
        <translation>Das Netz ist veraltet: eine Quelle oder eine Option hat sich geändert.</translation>
    </message>
    <message>
        <source>Of {}, as curved elements of order {}</source>
        <translation>Von {}, als gekrümmte Elemente der Ordnung {}</translation>
    </message>
    <message>
        <source>The ending chooses the format: {}</source>
        <translation>Die Endung bestimmt das Format: {}</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Cancelled; no file was written.</source>
        <translation>Abgebrochen; es wurde keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>The file exists and will be replaced.</source>
        <translation>Die Datei gibt es schon; sie wird ersetzt.</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>Of {}</source>
        <translation>Von {}</translation>
    </message>
    <message>
        <source>Cancelled; nothing was changed.</source>
        <translation>Abgebrochen; es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Counting triangles ...</source>
        <translation>Dreiecke werden gezählt ...</translation>
    </message>
    <message>
        <source>{} triangles</source>
        <translation>{} Dreiecke</translation>
    </message>
    <message>
        <source>More than {} triangles</source>
        <translation>Mehr als {} Dreiecke</translation>
    </message>
    <message>
        <source>Edit options</source>
        <translation>Optionen bearbeiten</translation>
    </message>
    <message>
        <source>Update mesh</source>
        <translation>Netz aktualisieren</translation>
    </message>
    <message>
        <source>Edit {}</source>
        <translation>{} bearbeiten</translation>
    </message>
    <message>
        <source>More options</source>
        <translation>Weitere Optionen</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>The distance from the shape is not bounded.</source>
        <translation>Der Abstand von der Form ist nicht begrenzt.</translation>
    </message>
    <message>
        <source>Before it is curved, the mesh keeps within {} of the shape.</source>
        <translation>Vor dem Krümmen weicht das Netz höchstens {} von der Form ab.</translation>
    </message>
    <message>
        <source>Keeps within {} of the shape.</source>
        <translation>Weicht höchstens {} von der Form ab.</translation>
    </message>
    <message>
        <source>Update {}</source>
        <translation>{} aktualisieren</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Algorithm: default divides triangles along the exact intersection; uniform is the sampling scheme of Wang 2010, for two operands</source>
        <translation>Verfahren: entweder werden Dreiecke längs der genauen Schnittlinie geteilt, oder die Körper werden nach Wang 2010 abgetastet (für zwei Operanden)</translation>
    </message>
    <message>
        <source>Applied from the first operand on</source>
        <translation>Angewandt vom ersten Operanden an</translation>
    </message>
    <message>
        <source>Boolean</source>
        <translation>Boolesche Operation</translation>
    </message>
    <message>
        <source>Coarse</source>
        <translation>Grob</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Display within</source>
        <translation>Anzeige auf</translation>
    </message>
    <message>
        <source>Distance to the shape</source>
        <translation>Abstand zur Form</translation>
    </message>
    <message>
        <source>Fill solids with tetrahedra</source>
        <translation>Körper mit Tetraedern füllen</translation>
    </message>
    <message>
        <source>Fill the solids with tetrahedra</source>
        <translation>Füllt die Körper mit Tetraedern</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>How samples are joined: pseudo-delaunay in space, parametric in (u, v)</source>
        <translation>Wie Abtastpunkte verbunden werden: im Raum oder in den Parametern (u, v) der Fläche</translation>
    </message>
    <message>
        <source>Largest distance between the mesh and the shape</source>
        <translation>Größter Abstand zwischen Netz und Form</translation>
    </message>
    <message>
        <source>Largest distance between the straight mesh and the shape</source>
        <translation>Größter Abstand zwischen dem geraden Netz und der Form</translation>
    </message>
    <message>
        <source>Largest distance between the triangles shown and the curved elements</source>
        <translation>Größter Abstand zwischen den gezeigten Dreiecken und den gekrümmten Elementen</translation>
    </message>
    <message>
        <source>Largest distance of the result from the exact one</source>
        <translation>Größter Abstand des Ergebnisses vom genauen Ergebnis</translation>
    </message>
    <message>
        <source>Leave out faces that fail</source>
        <translation>Misslungene Flächen auslassen</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Längste Kante</translation>
    </message>
    <message>
        <source>Longest edge of a triangle</source>
        <translation>Längste Kante eines Dreiecks</translation>
    </message>
    <message>
        <source>Longest edge of the straight mesh</source>
        <translation>Längste Kante des geraden Netzes</translation>
    </message>
    <message>
        <source>Make elements straight that stay invalid after all repairs</source>
        <translation>Macht Elemente gerade, die nach allen Reparaturen ungültig bleiben</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Mesh the rest of a part whose faces fail, and name those in the report</source>
        <translation>Vernetzt den Rest eines Teils, dessen Flächen misslingen, und nennt diese im Bericht</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Most triangles</source>
        <translation>Höchstzahl der Dreiecke</translation>
    </message>
    <message>
        <source>New points</source>
        <translation>Neue Punkte</translation>
    </message>
    <message>
        <source>No edge is split into shorter ones than this</source>
        <translation>Keine Kante wird in kürzere als diese geteilt</translation>
    </message>
    <message>
        <source>Of the random points of sprinkle; the same seed gives the same mesh</source>
        <translation>Für die Zufallspunkte; gleicher Startwert gibt das gleiche Netz</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Order of the elements</source>
        <translation>Ordnung der Elemente</translation>
    </message>
    <message>
        <source>Order of the elements: 1 to 5, with tetrahedra to 4</source>
        <translation>Ordnung der Elemente: 1 bis 5, mit Tetraedern bis 4</translation>
    </message>
    <message>
        <source>Parts along the longest side; gives the tolerance where that is not given</source>
        <translation>Teile längs der längsten Seite; bestimmt die Toleranz, wo diese nicht angegeben ist</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Startwert des Zufalls</translation>
    </message>
    <message>
        <source>Refine after sampling</source>
        <translation>Nach dem Abtasten verfeinern</translation>
    </message>
    <message>
        <source>Refine after sampling, so that the bounds on angle and distance hold</source>
        <translation>Verfeinert nach dem Abtasten, damit die Schranken für Winkel und Abstand gelten</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Samples are joined</source>
        <translation>Punkte verbinden</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Shortest edge</source>
        <translation>Kürzeste Kante</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>Kleinster Winkel</translation>
    </message>
    <message>
        <source>Smallest angle of a triangle; beyond about 30 the triangles grow many</source>
        <translation>Kleinster Winkel eines Dreiecks; über etwa 30 werden es sehr viele Dreiecke</translation>
    </message>
    <message>
        <source>Smallest angle of the straight triangles</source>
        <translation>Kleinster Winkel der geraden Dreiecke</translation>
    </message>
    <message>
        <source>Straight mesh</source>
        <translation>Gerades Netz</translation>
    </message>
    <message>
        <source>Straighten faulty elements</source>
        <translation>Fehlerhafte begradigen</translation>
    </message>
    <message>
        <source>The same as a part of the shape&apos;s largest dimension</source>
        <translation>Dasselbe als Teil der größten Abmessung der Form</translation>
    </message>
    <message>
        <source>The same as a part of the shape&apos;s largest dimension; 0.01 unless one is given</source>
        <translation>Dasselbe als Teil der größten Abmessung der Form; 0,01, wenn nichts angegeben ist</translation>
    </message>
    <message>
        <source>The same, as a part of the size</source>
        <translation>Dasselbe, als Teil der Größe</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Very fine</source>
        <translation>Sehr fein</translation>
    </message>
    <message>
        <source>Where a triangle with a small angle gets its new point: off-centre needs fewer triangles, paper is the rule of Aftosmis 1999</source>
        <translation>Wo ein Dreieck mit kleinem Winkel seinen neuen Punkt bekommt: so, dass wenige Dreiecke entstehen, oder nach der Regel von Aftosmis 1999</translation>
    </message>
    <message>
        <source>Work ends, incomplete, at this number; 5 million unless given</source>
        <translation>Die Arbeit endet unvollständig bei dieser Zahl; 5 Millionen, wenn nichts angegeben ist</translation>
    </message>
    <message>
        <source>as Aftosmis 1999</source>
        <translation>wie Aftosmis 1999</translation>
    </message>
    <message>
        <source>by resolution</source>
        <translation>nach Auflösung</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>abziehen</translation>
    </message>
    <message>
        <source>exact intersection</source>
        <translation>genauer Schnitt</translation>
    </message>
    <message>
        <source>few triangles</source>
        <translation>wenige Dreiecke</translation>
    </message>
    <message>
        <source>in face parameters</source>
        <translation>in Parametern</translation>
    </message>
    <message>
        <source>in space</source>
        <translation>im Raum</translation>
    </message>
    <message>
        <source>join</source>
        <translation>vereinigen</translation>
    </message>
    <message>
        <source>keep the common part</source>
        <translation>Gemeinsames behalten</translation>
    </message>
    <message>
        <source>keep what is in one only</source>
        <translation>nur Einzelnes behalten</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>ohne Angabe</translation>
    </message>
    <message>
        <source>refine inserts points until every angle and distance fits; star (hexagons) and sprinkle (random points) first lay points on the faces, denser where they bend</source>
        <translation>Entweder werden Punkte eingefügt, bis jeder Winkel und Abstand stimmt, oder es werden zuerst Punkte auf die Flächen gelegt (in Sechsecken oder zufällig), dichter, wo diese gekrümmt sind</translation>
    </message>
    <message>
        <source>refine where needed</source>
        <translation>verfeinern</translation>
    </message>
    <message>
        <source>sample at random</source>
        <translation>zufällig abtasten</translation>
    </message>
    <message>
        <source>sample in hexagons</source>
        <translation>in Sechsecken</translation>
    </message>
    <message>
        <source>sampling (Wang 2010)</source>
        <translation>abtasten (Wang)</translation>
    </message>
    <message>
        <source>size / 1000</source>
        <translation>Größe / 1000</translation>
    </message>
    <message>
        <source>Edges where the surface turns by more than this stay where they are</source>
        <translation>Kanten, an denen sich die Fläche um mehr als dies dreht, bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>Largest distance between the mesh and its better version</source>
        <translation>Größter Abstand zwischen dem Netz und dem verbesserten</translation>
    </message>
    <message>
        <source>Sharp from</source>
        <translation>Scharf ab</translation>
    </message>
    <message>
        <source>Smallest angle that every triangle is to reach</source>
        <translation>Kleinster Winkel, den jedes Dreieck erreichen soll</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Computes, and leaves the panel open</source>
        <translation>Berechnet, und lässt den Aufgabenbereich offen</translation>
    </message>
    <message>
        <source>Add the faces, edges and vertices that are selected in the 3D view</source>
        <translation>Die in der 3D-Ansicht ausgewählten Flächen, Kanten und Ecken hinzufügen</translation>
    </message>
    <message>
        <source>Longest edge on single faces, edges or around vertices: Face3=0.5, Edge7=0.2</source>
        <translation>Längste Kante auf einzelnen Flächen, Kanten oder um Ecken: Face3=0.5, Edge7=0.2</translation>
    </message>
    <message>
        <source>Shorter edges on</source>
        <translation>Kürzere Kanten auf</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>nirgends</translation>
    </message>
    <message>
        <source>{0} below {1}</source>
        <translation>{0} unter {1}</translation>
    </message>
    <message>
        <source>{0} above {1}</source>
        <translation>{0} über {1}</translation>
    </message>
    <message>
        <source>{0} from {1} to {2}</source>
        <translation>{0} von {1} bis {2}</translation>
    </message>
    <message>
        <source>Longest edge / shortest edge</source>
        <translation>Längste Kante / kürzeste Kante</translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation>Skalierte Jacobi-Determinante</translation>
    </message>
    <message>
        <source>element {0}</source>
        <translation>Element {0}</translation>
    </message>
    <message>
        <source>element {0} on {1}</source>
        <translation>Element {0} auf {1}</translation>
    </message>
    <message>
        <source>The mesh cannot be drawn in colour: {0}</source>
        <translation>Das Netz kann nicht farbig gezeichnet werden: {0}</translation>
    </message>
    <message>
        <source>Mesh quality</source>
        <translation>Netzqualität</translation>
    </message>
    <message>
        <source>Of {0}</source>
        <translation>Von {0}</translation>
    </message>
    <message>
        <source>Draw edges</source>
        <translation>Kanten zeichnen</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Schlechtester</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Worst elements</source>
        <translation>Schlechteste Elemente</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Measuring ...</source>
        <translation>Es wird gemessen ...</translation>
    </message>
    <message>
        <source>Measuring: {0} %</source>
        <translation>Es wird gemessen: {0} %</translation>
    </message>
    <message>
        <source>{0} elements: worst {1}, mean {2}</source>
        <translation>{0} Elemente: schlechtestes {1}, Mittel {2}</translation>
    </message>
    <message>
        <source>Click to fly there</source>
        <translation>Klicken, um dorthin zu fliegen</translation>
    </message>
    <message>
        <source>Click a bar to see where its elements are.</source>
        <translation>Auf einen Balken klicken, um zu sehen, wo seine Elemente liegen.</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Verzerrung</translation>
    </message>
</context>
<context>
    <name>MeshQualityPreferences</name>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Aufgabenbereiche</translation>
    </message>
    <message>
        <source>Smallest angle of new meshes</source>
        <translation>Kleinster Winkel neuer Netze</translation>
    </message>
    <message>
        <source>Beyond about 30 degrees the triangles grow many</source>
        <translation>Über etwa 30 Grad werden es sehr viele Dreiecke</translation>
    </message>
    <message>
        <source>Begin with the values that were used last</source>
        <translation>Mit den zuletzt benutzten Werten beginnen</translation>
    </message>
    <message>
        <source>Otherwise panels begin with medium fineness and the angle above</source>
        <translation>Sonst wird mit mittlerer Feinheit und dem Winkel oben begonnen</translation>
    </message>
    <message>
        <source>Updates</source>
        <translation>Aktualisierung</translation>
    </message>
    <message>
        <source>New meshes wait for Update mesh above</source>
        <translation>Neue Netze warten auf „Netz aktualisieren“ ab</translation>
    </message>
    <message>
        <source>Larger meshes do not follow each change of their source by themselves</source>
        <translation>Größere Netze folgen nicht von selbst jeder Änderung ihrer Quelle</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> Dreiecken</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Analyse</name>
    <message>
        <source>Analyse quality...</source>
        <translation>Netzqualität untersuchen...</translation>
    </message>
    <message>
        <source>Colour the selected mesh by its quality and find its worst elements</source>
        <translation>Färbt das gewählte Netz nach seiner Qualität und findet die schlechtesten Elemente</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Boolean</name>
    <message>
        <source>Join, intersect or subtract the selected meshes and shapes, in the order of selection</source>
        <translation>Vereinigt, schneidet oder subtrahiert die gewählten Netze und Formen in der Reihenfolge der Auswahl</translation>
    </message>
    <message>
        <source>Mesh Boolean...</source>
        <translation>Boolesche Netzoperation...</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Curve</name>
    <message>
        <source>Curved mesh...</source>
        <translation>Gekrümmtes Netz...</translation>
    </message>
    <message>
        <source>Mesh the selected shapes with curved elements, each proven to be free of folds</source>
        <translation>Vernetzt die gewählten Formen mit gekrümmten Elementen, jedes nachweislich ohne Falten</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Export</name>
    <message>
        <source>Export curved mesh...</source>
        <translation>Gekrümmtes Netz exportieren...</translation>
    </message>
    <message>
        <source>Write the curved elements of the selected mesh into a file for Gmsh, ParaView or a solver</source>
        <translation>Schreibt die gekrümmten Elemente des gewählten Netzes in eine Datei für Gmsh, ParaView oder einen Löser</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Improve</name>
    <message>
        <source>Better triangles on the surface of the selected meshes; sharp edges stay</source>
        <translation>Bessere Dreiecke auf der Oberfläche der gewählten Netze; scharfe Kanten bleiben</translation>
    </message>
    <message>
        <source>Improve mesh...</source>
        <translation>Netz verbessern...</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Triangulate</name>
    <message>
        <source>Mesh the selected shapes with a guaranteed smallest angle</source>
        <translation>Vernetzt die gewählten Formen mit garantiertem kleinsten Winkel</translation>
    </message>
    <message>
        <source>Quality mesh...</source>
        <translation>Qualitätsnetz...</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Update</name>
    <message>
        <source>Compute the selected meshes anew where a source or an option has changed</source>
        <translation>Berechnet die gewählten Netze neu, wo sich eine Quelle oder eine Option geändert hat</translation>
    </message>
    <message>
        <source>Update mesh...</source>
        <translation>Netz aktualisieren...</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Mesh Quality</source>
        <translation>Netzqualität</translation>
    </message>
</context>
</TS>
