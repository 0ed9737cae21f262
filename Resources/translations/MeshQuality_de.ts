<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>App::Property</name>
    <message>
        <source>Algorithm: default divides triangles along the exact intersection; uniform is the sampling scheme of Wang 2010, for two operands</source>
        <translation>Verfahren: entweder werden Dreiecke längs der genauen Schnittlinie geteilt, oder die Körper werden nach Wang 2010 abgetastet (für zwei Operanden)</translation>
    </message>
    <message>
        <source>CAD faces on which the mesh misses what was asked for</source>
        <translation>CAD-Flächen, auf denen das Netz das Verlangte verfehlt</translation>
    </message>
    <message>
        <source>Corners of the triangle where it misses that most</source>
        <translation>Ecken des Dreiecks, in dem es das am meisten verfehlt</translation>
    </message>
    <message>
        <source>Corners that a repair moved</source>
        <translation>Ecken, die eine Reparatur verschoben hat</translation>
    </message>
    <message>
        <source>Distance from the exact Boolean that the mesh was to keep within</source>
        <translation>Verlangter größter Abstand vom genauen Ergebnis</translation>
    </message>
    <message>
        <source>Distance to the shape that the mesh was to keep within; 0: none</source>
        <translation>Verlangter größter Abstand zur Form; 0: keiner</translation>
    </message>
    <message>
        <source>Edges where the surface turns by more than this stay where they are</source>
        <translation>Kanten, an denen sich die Fläche um mehr als dies dreht, bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>Elements that are not proven to be free of folds; there should be none</source>
        <translation>Elemente, deren Faltenfreiheit nicht bewiesen ist; es sollte keine geben</translation>
    </message>
    <message>
        <source>Elements that were made straight, as they stayed invalid</source>
        <translation>Elemente, die begradigt wurden, weil sie ungültig blieben</translation>
    </message>
    <message>
        <source>Enclosed volume</source>
        <translation>Eingeschlossenes Volumen</translation>
    </message>
    <message>
        <source>Faults that no repair removed</source>
        <translation>Fehler, die keine Reparatur beseitigt hat</translation>
    </message>
    <message>
        <source>Fill the solids with tetrahedra</source>
        <translation>Füllt die Körper mit Tetraedern</translation>
    </message>
    <message>
        <source>How far that is off the volume of the shape, as a part of it; -1: the shape has none</source>
        <translation>Wie weit das vom Volumen der Form abweicht, als Teil davon; -1: die Form hat keines</translation>
    </message>
    <message>
        <source>How samples are joined: pseudo-delaunay in space, parametric in (u, v)</source>
        <translation>Wie Abtastpunkte verbunden werden: im Raum oder in den Parametern (u, v) der Fläche</translation>
    </message>
    <message>
        <source>Largest angle of all triangles</source>
        <translation>Größter Winkel aller Dreiecke</translation>
    </message>
    <message>
        <source>Largest distance between the mesh and its better version; 0: size / 1000</source>
        <translation>Größter Abstand zwischen dem Netz und dem verbesserten; 0: Größe / 1000</translation>
    </message>
    <message>
        <source>Largest distance between the mesh and the shape; 0: any</source>
        <translation>Größter Abstand zwischen Netz und Form; 0: beliebig</translation>
    </message>
    <message>
        <source>Largest distance between the triangles shown and the curved elements; 0: size / 1000</source>
        <translation>Größter Abstand zwischen den gezeigten Dreiecken und den gekrümmten Elementen; 0: Größe / 1000</translation>
    </message>
    <message>
        <source>Largest distance from the exact Boolean of the meshes</source>
        <translation>Größter Abstand vom genauen Ergebnis der Netze</translation>
    </message>
    <message>
        <source>Largest distance of the elements from the shape</source>
        <translation>Größter Abstand der Elemente von der Form</translation>
    </message>
    <message>
        <source>Largest distance of the result from the exact one; 0: by resolution</source>
        <translation>Größter Abstand des Ergebnisses vom genauen Ergebnis; 0: nach Auflösung</translation>
    </message>
    <message>
        <source>Largest measured distance to the shape</source>
        <translation>Größter gemessener Abstand zur Form</translation>
    </message>
    <message>
        <source>Longest edge of a triangle; 0: any</source>
        <translation>Längste Kante eines Dreiecks; 0: beliebig</translation>
    </message>
    <message>
        <source>Longest edge on single faces, edges or around vertices: Face3=0.5, Edge7=0.2; 0: nowhere</source>
        <translation>Längste Kante auf einzelnen Flächen, Kanten oder um Ecken: Face3=0.5, Edge7=0.2; 0: nirgends</translation>
    </message>
    <message>
        <source>Mean of that ratio over the elements</source>
        <translation>Mittel dieses Verhältnisses über die Elemente</translation>
    </message>
    <message>
        <source>Mesh the rest of a part whose faces fail, and name those in the report</source>
        <translation>Vernetzt den Rest eines Teils, dessen Flächen misslingen, und nennt diese im Bericht</translation>
    </message>
    <message>
        <source>Neighbouring triangles agree on outside</source>
        <translation>Benachbarte Dreiecke stimmen überein, wo außen ist</translation>
    </message>
    <message>
        <source>No edge is split into shorter ones than this; 0: any</source>
        <translation>Keine Kante wird in kürzere als diese geteilt; 0: beliebig</translation>
    </message>
    <message>
        <source>Number of corners of elements</source>
        <translation>Anzahl der Ecken von Elementen</translation>
    </message>
    <message>
        <source>Number of tetrahedra, or of triangles without a volume</source>
        <translation>Anzahl der Tetraeder, ohne Volumen der Dreiecke</translation>
    </message>
    <message>
        <source>Number of triangles</source>
        <translation>Anzahl der Dreiecke</translation>
    </message>
    <message>
        <source>Number of vertices</source>
        <translation>Anzahl der Eckpunkte</translation>
    </message>
    <message>
        <source>Of the input and the options of this mesh</source>
        <translation>Von Eingabe und Optionen dieses Netzes</translation>
    </message>
    <message>
        <source>Of the random points of sprinkle; the same seed gives the same mesh</source>
        <translation>Für die Zufallspunkte; gleicher Startwert gibt das gleiche Netz</translation>
    </message>
    <message>
        <source>Of what the elements were made of</source>
        <translation>Wovon die Elemente gemacht sind</translation>
    </message>
    <message>
        <source>Order of the elements that are kept</source>
        <translation>Ordnung der aufbewahrten Elemente</translation>
    </message>
    <message>
        <source>Pairs (index of a CAD face, number of successive triangles on it)</source>
        <translation>Paare (Nummer einer CAD-Fläche, Zahl der Dreiecke in Folge auf ihr)</translation>
    </message>
    <message>
        <source>Refine after sampling, so that the bounds on angle and distance hold</source>
        <translation>Verfeinert nach dem Abtasten, damit die Schranken für Winkel und Abstand gelten</translation>
    </message>
    <message>
        <source>Root mean square of that distance</source>
        <translation>Quadratisches Mittel dieses Abstands</translation>
    </message>
    <message>
        <source>Smallest Jacobian of all elements, each against that of its straight element: 1 is best, 0 or less is invalid</source>
        <translation>Kleinste Jacobi-Determinante aller Elemente, je im Verhältnis zum geraden Element: 1 ist am besten, 0 oder weniger ist ungültig</translation>
    </message>
    <message>
        <source>Smallest angle of all triangles</source>
        <translation>Kleinster Winkel aller Dreiecke</translation>
    </message>
    <message>
        <source>Smallest angle that every triangle is to reach</source>
        <translation>Kleinster Winkel, den jedes Dreieck erreichen soll</translation>
    </message>
    <message>
        <source>Smallest angle that was asked for</source>
        <translation>Verlangter kleinster Winkel</translation>
    </message>
    <message>
        <source>Smallest ratio of the least to the largest Jacobian of one element: 1 is best, 0 or less is invalid</source>
        <translation>Kleinstes Verhältnis der kleinsten zur größten Jacobi-Determinante eines Elements: 1 ist am besten, 0 oder weniger ist ungültig</translation>
    </message>
    <message>
        <source>The mesh has no border edge</source>
        <translation>Das Netz hat keine Randkante</translation>
    </message>
    <message>
        <source>The mesh has no edge of three or more triangles and no pinched vertex</source>
        <translation>Das Netz hat keine Kante mit drei oder mehr Dreiecken und keinen Punkt, in dem es sich nur berührt</translation>
    </message>
    <message>
        <source>The mesh was to have no border edge</source>
        <translation>Das Netz sollte keine Randkante haben</translation>
    </message>
    <message>
        <source>The object whose mesh is improved</source>
        <translation>Das Objekt, dessen Netz verbessert wird</translation>
    </message>
    <message>
        <source>The object whose shape is meshed</source>
        <translation>Das Objekt, dessen Form vernetzt wird</translation>
    </message>
    <message>
        <source>The operands: objects with a mesh or a shape, in their order</source>
        <translation>Die Operanden: Objekte mit einem Netz oder einer Form, in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>The same as a part of the shape&apos;s largest dimension; 0.01 unless one is given; 0: not given</source>
        <translation>Dasselbe als Teil der größten Abmessung der Form; 0,01, wenn nichts angegeben ist; 0: ohne Angabe</translation>
    </message>
    <message>
        <source>Triangles below the angle asked for, and why</source>
        <translation>Dreiecke unter dem verlangten Winkel, und warum</translation>
    </message>
    <message>
        <source>Triangles that are an operand&apos;s own</source>
        <translation>Dreiecke, die unverändert von einem Operanden stammen</translation>
    </message>
    <message>
        <source>Triangles that were made or changed</source>
        <translation>Dreiecke, die neu oder verändert sind</translation>
    </message>
    <message>
        <source>What else happened on the way</source>
        <translation>Was sonst unterwegs geschah</translation>
    </message>
    <message>
        <source>What the colours of the elements show</source>
        <translation>Was die Farben der Elemente zeigen</translation>
    </message>
    <message>
        <source>What the elements enclose</source>
        <translation>Was die Elemente einschließen</translation>
    </message>
    <message>
        <source>What the triangles shown keep within</source>
        <translation>Wie genau die gezeigten Dreiecke sind</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>What was repaired in the operands</source>
        <translation>Was an den Operanden repariert wurde</translation>
    </message>
    <message>
        <source>What was repaired, and how often</source>
        <translation>Was repariert wurde, und wie oft</translation>
    </message>
    <message>
        <source>Where a triangle with a small angle gets its new point: off-centre needs fewer triangles, paper is the rule of Aftosmis 1999</source>
        <translation>Wo ein Dreieck mit kleinem Winkel seinen neuen Punkt bekommt: so, dass wenige Dreiecke entstehen, oder nach der Regel von Aftosmis 1999</translation>
    </message>
    <message>
        <source>Whether the mesh follows its sources and options by itself, or when it is asked to</source>
        <translation>Ob das Netz seinen Quellen und Optionen von selbst folgt oder auf Verlangen</translation>
    </message>
    <message>
        <source>Whether the mesh is that of its sources and options</source>
        <translation>Ob das Netz das seiner Quellen und Optionen ist</translation>
    </message>
    <message>
        <source>Whether the mesh keeps what was asked for; where not, what it misses and where</source>
        <translation>Ob das Netz das Verlangte einhält; wenn nicht, was es verfehlt und wo</translation>
    </message>
    <message>
        <source>Which elements are invalid</source>
        <translation>Welche Elemente ungültig sind</translation>
    </message>
    <message>
        <source>refine inserts points until every angle and distance fits; star (hexagons) and sprinkle (random points) first lay points on the faces, denser where they bend</source>
        <translation>Entweder werden Punkte eingefügt, bis jeder Winkel und Abstand stimmt, oder es werden zuerst Punkte auf die Flächen gelegt (in Sechsecken oder zufällig), dichter, wo diese gekrümmt sind</translation>
    </message>
    <message>
        <source>Elements that were invalid before repair</source>
        <translation>Elemente, die vor der Reparatur ungültig waren</translation>
    </message>
    <message>
        <source>The same as a part of the shape&apos;s largest dimension: 0.001 is a thousandth; 0: any</source>
        <translation>Dasselbe als Teil der größten Abmessung der Form: 0,001 ist ein Tausendstel; 0: beliebig</translation>
    </message>
    <message>
        <source>What is done with the operands, one after the other from the first on</source>
        <translation>Was mit den Operanden geschieht, nacheinander vom ersten an</translation>
    </message>
    <message>
        <source>1: straight sides; 2: quadratic elements, which most FEM programs want; at most 5, with tetrahedra 4</source>
        <translation>1: gerade Seiten; 2: quadratische Elemente, wie die meisten FEM-Programme sie brauchen; höchstens 5, mit Tetraedern 4</translation>
    </message>
    <message>
        <source>Into how many parts the longest side is cut: more parts follow the operands more closely and take longer. Gives the tolerance where that is 0</source>
        <translation>In wie viele Teile die längste Seite geteilt wird: mehr Teile folgen den Operanden genauer und dauern länger. Bestimmt die Toleranz, wo diese 0 ist</translation>
    </message>
    <message>
        <source>Work ends, incomplete, at this number; 0: 5 million</source>
        <translation>Die Arbeit endet unvollständig bei dieser Zahl; 0: 5 Millionen</translation>
    </message>
    <message>
        <source>Largest distance between the mesh and the shape before it is curved; 0: not given</source>
        <translation>Größter Abstand zwischen Netz und Form, bevor es gekrümmt wird; 0: ohne Angabe</translation>
    </message>
    <message>
        <source>Longest edge of the mesh before it is curved; 0: any</source>
        <translation>Längste Kante des Netzes, bevor es gekrümmt wird; 0: beliebig</translation>
    </message>
    <message>
        <source>Make those elements straight that fold over and cannot be repaired</source>
        <translation>Macht jene Elemente gerade, die umklappen und sich nicht reparieren lassen</translation>
    </message>
    <message>
        <source>No triangle gets a smaller angle than this, unless the part has a sharper corner; beyond about 30 many more triangles are needed</source>
        <translation>Kein Dreieck bekommt einen kleineren Winkel, außer wo das Teil selbst eine schärfere Ecke hat; über etwa 30 braucht es viel mehr Dreiecke</translation>
    </message>
    <message>
        <source>Smallest angle of the triangles before they are curved</source>
        <translation>Kleinster Winkel der Dreiecke, bevor sie gekrümmt werden</translation>
    </message>
    <message>
        <source>How far the worst element is from equal sides and angles: 1 is best, 5 is poor, infinite: it folds over</source>
        <translation>Wie weit das schlechteste Element von gleichen Seiten und Winkeln entfernt ist: 1 ist am besten, 5 ist schlecht, unendlich: es klappt um</translation>
    </message>
    <message>
        <source>Bent edges and faces get at least so many edges for each full turn: 12 to 36 is usual; 0: any</source>
        <translation>Gebogene Kanten und Flächen erhalten mindestens so viele Dreieckskanten je volle Umdrehung: 12 bis 36 sind üblich; 0: beliebig</translation>
    </message>
    <message>
        <source>How many times longer than their neighbours edges become on the way from fine places to coarse ones: 1.2 is slow, 2 is fast; 0: any</source>
        <translation>Wievielmal so lang wie ihre Nachbarn Kanten auf dem Weg von feinen zu groben Stellen werden: 1,2 ist langsam, 2 ist schnell; 0: beliebig</translation>
    </message>
    <message>
        <source>Which edges of the shape the mesh follows: all, or feature: not those that the surface crosses smoothly, which triangles then may span</source>
        <translation>Welchen Kanten der Form das Netz folgt: allen, oder nur scharfen: nicht denen, über die die Fläche glatt hinweggeht; über diese dürfen Dreiecke dann hinwegreichen</translation>
    </message>
    <message>
        <source>With keep_edges = feature: edges are smooth where the surface turns by less than this</source>
        <translation>Wenn nur scharfe Kanten bleiben: glatt sind Kanten, an denen sich die Fläche um weniger als dies dreht</translation>
    </message>
    <message>
        <source>After an edit, faces that did not change keep their triangles, which is faster; undo gives the mesh that was there. Off: each mesh is made from nothing, and depends on the shape and the options alone</source>
        <translation>Nach einer Änderung behalten Flächen, die gleich geblieben sind, ihre Dreiecke, was schneller ist; Rückgängig bringt das Netz, das da war. Aus: jedes Netz entsteht von Grund auf und hängt allein von der Form und den Optionen ab</translation>
    </message>
    <message>
        <source>Faces of the shape that kept their triangles through the last edit</source>
        <translation>Flächen der Form, deren Dreiecke bei der letzten Änderung geblieben sind</translation>
    </message>
</context>
<context>
    <name>MeshQuality</name>
    <message>
        <source>Show where</source>
        <translation>Zeigen, wo</translation>
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
        <source>Straighten faulty elements</source>
        <translation>Fehlerhafte begradigen</translation>
    </message>
    <message>
        <source>The same as a part of the shape&apos;s largest dimension; 0.01 unless one is given</source>
        <translation>Dasselbe als Teil der größten Abmessung der Form; 0,01, wenn nichts angegeben ist</translation>
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
        <source>Worst</source>
        <translation>Schlechteste</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
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
        <source>Flies to the place, and selects the faces of the part on which the mesh misses what was asked for</source>
        <translation>Fliegt an die Stelle und wählt die Flächen des Teils aus, auf denen das Netz das Verlangte verfehlt</translation>
    </message>
    <message>
        <source>Source is empty: choose an object with a shape</source>
        <translation>Es ist keine Quelle angegeben: ein Objekt mit einer Form wählen</translation>
    </message>
    <message>
        <source>Source is not a mesh: choose one object with a mesh</source>
        <translation>Die Quelle ist kein Netz: ein Objekt mit einem Netz wählen</translation>
    </message>
    <message>
        <source>Sources has {count} objects: choose two or more with a mesh or a shape</source>
        <translation>Es sind {count} Objekte gewählt: zwei oder mehr mit einem Netz oder einer Form wählen</translation>
    </message>
    <message>
        <source>The distance to the shape is given twice, as {number} mm and as {number2} of the size: set one of them to 0</source>
        <translation>Der Abstand zur Form ist doppelt angegeben, als {number} mm und als {number2} der Größe: einen davon auf 0 setzen</translation>
    </message>
    <message>
        <source>The shortest edge of {number} mm is longer than the longest edge of {number2} mm</source>
        <translation>Die kürzeste Kante von {number} mm ist länger als die längste Kante von {number2} mm</translation>
    </message>
    <message>
        <source>a further point would fold the mesh</source>
        <translation>ein weiterer Punkt würde das Netz falten</translation>
    </message>
    <message>
        <source>a further point would lie too near to be told apart in the numbers that FreeCAD keeps</source>
        <translation>ein weiterer Punkt läge so nahe, dass FreeCADs Zahlen ihn nicht mehr unterscheiden</translation>
    </message>
    <message>
        <source>a further point would make an edge shorter than the shortest that is allowed</source>
        <translation>ein weiterer Punkt würde eine Kante kürzer machen, als erlaubt ist</translation>
    </message>
    <message>
        <source>a further point would not make the triangles around it better</source>
        <translation>ein weiterer Punkt würde die Dreiecke um ihn nicht besser machen</translation>
    </message>
    <message>
        <source>a limit ended the work early</source>
        <translation>eine Grenze hat die Arbeit vorzeitig beendet</translation>
    </message>
    <message>
        <source>at least {number}</source>
        <translation>mindestens {number}</translation>
    </message>
    <message>
        <source>at least {number} and at most {number2}</source>
        <translation>mindestens {number} und höchstens {number2}</translation>
    </message>
    <message>
        <source>checking the result</source>
        <translation>Ergebnis wird geprüft</translation>
    </message>
    <message>
        <source>closing gaps</source>
        <translation>Lücken werden geschlossen</translation>
    </message>
    <message>
        <source>combining the points</source>
        <translation>Punkte werden verknüpft</translation>
    </message>
    <message>
        <source>curving the surface</source>
        <translation>Oberfläche wird gekrümmt</translation>
    </message>
    <message>
        <source>cutting into triangles</source>
        <translation>Zerlegung in Dreiecke</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>distance from the exact result {number} of {number2} mm</source>
        <translation>Abstand vom genauen Ergebnis {number} statt {number2} mm</translation>
    </message>
    <message>
        <source>distance to the shape {number} of {number2} mm</source>
        <translation>Abstand zur Form {number} statt {number2} mm</translation>
    </message>
    <message>
        <source>dividing the space</source>
        <translation>Raum wird geteilt</translation>
    </message>
    <message>
        <source>dividing triangles</source>
        <translation>Dreiecke werden geteilt</translation>
    </message>
    <message>
        <source>edges near the narrow corner at {vertex} would shrink without end</source>
        <translation>Kanten nahe der engen Ecke bei {vertex} würden endlos kürzer</translation>
    </message>
    <message>
        <source>filling with tetrahedra</source>
        <translation>Füllen mit Tetraedern</translation>
    </message>
    <message>
        <source>finding what is inside</source>
        <translation>Inneres wird gesucht</translation>
    </message>
    <message>
        <source>finding where they cross</source>
        <translation>Schnitte werden gesucht</translation>
    </message>
    <message>
        <source>first triangles</source>
        <translation>erste Dreiecke</translation>
    </message>
    <message>
        <source>fitting to the shapes</source>
        <translation>Anpassen an die Formen</translation>
    </message>
    <message>
        <source>for no known reason</source>
        <translation>ohne bekannten Grund</translation>
    </message>
    <message>
        <source>getting nearer to the shape</source>
        <translation>Annähern an die Form</translation>
    </message>
    <message>
        <source>greater than {number}</source>
        <translation>größer als {number}</translation>
    </message>
    <message>
        <source>greater than {number} and at most {number2}</source>
        <translation>größer als {number} und höchstens {number2}</translation>
    </message>
    <message>
        <source>greater than {number} and at most {number2} {unit}</source>
        <translation>größer als {number} und höchstens {number2} {unit}</translation>
    </message>
    <message>
        <source>greater than {number} {unit}</source>
        <translation>größer als {number} {unit}</translation>
    </message>
    <message>
        <source>grouping the points</source>
        <translation>Punkte werden gruppiert</translation>
    </message>
    <message>
        <source>improving</source>
        <translation>Verbessern</translation>
    </message>
    <message>
        <source>improving the angles</source>
        <translation>Winkel werden verbessert</translation>
    </message>
    <message>
        <source>its smallest angle lies between two sharp edges that must stay</source>
        <translation>sein kleinster Winkel liegt zwischen zwei scharfen Kanten, die bleiben müssen</translation>
    </message>
    <message>
        <source>laying points on the surface</source>
        <translation>Punkte werden auf die Fläche gelegt</translation>
    </message>
    <message>
        <source>lengths in mm greater than 0 by sub-elements, such as Face3=0.5, Edge7=0.2</source>
        <translation>Längen in mm größer als 0 für Unterelemente, etwa Face3=0.5, Edge7=0.2</translation>
    </message>
    <message>
        <source>looking at the operands</source>
        <translation>Operanden werden betrachtet</translation>
    </message>
    <message>
        <source>making the surface</source>
        <translation>Oberfläche entsteht</translation>
    </message>
    <message>
        <source>measuring the distance</source>
        <translation>Abstand wird gemessen</translation>
    </message>
    <message>
        <source>measuring the distortion</source>
        <translation>Verzerrung wird gemessen</translation>
    </message>
    <message>
        <source>mending what is left</source>
        <translation>Ausbessern</translation>
    </message>
    <message>
        <source>meshing the shapes</source>
        <translation>Formen werden vernetzt</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>no change within the tolerance makes it better</source>
        <translation>keine Änderung innerhalb der Toleranz macht es besser</translation>
    </message>
    <message>
        <source>not a clean surface: {count} edges of three or more triangles, {count2} points where it only touches itself, {count3} triangles without area</source>
        <translation>keine saubere Oberfläche: {count} Kanten mit drei oder mehr Dreiecken, {count2} Punkte, in denen sie sich nur berührt, {count3} Dreiecke ohne Fläche</translation>
    </message>
    <message>
        <source>not closed: {count} edges have one triangle only</source>
        <translation>nicht geschlossen: {count} Kanten haben nur ein Dreieck</translation>
    </message>
    <message>
        <source>on {face}</source>
        <translation>auf {face}</translation>
    </message>
    <message>
        <source>putting the result together</source>
        <translation>Ergebnis wird zusammengesetzt</translation>
    </message>
    <message>
        <source>reading the operands</source>
        <translation>Operanden werden gelesen</translation>
    </message>
    <message>
        <source>reading the shape</source>
        <translation>Form wird gelesen</translation>
    </message>
    <message>
        <source>repairing the surface</source>
        <translation>Oberfläche wird repariert</translation>
    </message>
    <message>
        <source>repairing the tetrahedra</source>
        <translation>Tetraeder werden repariert</translation>
    </message>
    <message>
        <source>separating what only touches</source>
        <translation>Trennen, was sich nur berührt</translation>
    </message>
    <message>
        <source>smallest angle {number} of {number2} degrees at triangle {count}: {phrase}</source>
        <translation>kleinster Winkel {number} statt {number2} Grad bei Dreieck {count}: {phrase}</translation>
    </message>
    <message>
        <source>sorting the triangles</source>
        <translation>Dreiecke werden sortiert</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>tetrahedron {count} of {solid}</source>
        <translation>Tetraeder {count} von {solid}</translation>
    </message>
    <message>
        <source>the largest number of triangles was reached</source>
        <translation>die Höchstzahl der Dreiecke ist erreicht</translation>
    </message>
    <message>
        <source>the shape has no usable point there</source>
        <translation>die Form hat dort keinen brauchbaren Punkt</translation>
    </message>
    <message>
        <source>the surface comes to a point at {vertex} with too little angle around it</source>
        <translation>die Fläche läuft bei {vertex} in eine Spitze mit zu wenig Winkel darum aus</translation>
    </message>
    <message>
        <source>triangle {count} on {face}</source>
        <translation>Dreieck {count} auf {face}</translation>
    </message>
    <message>
        <source>what is to be meshed is not in its document any more: close the panel</source>
        <translation>was vernetzt werden soll, ist nicht mehr in seinem Dokument: den Aufgabenbereich schließen</translation>
    </message>
    <message>
        <source>{count} faults are left that no repair removed</source>
        <translation>{count} Fehler bleiben, die keine Reparatur beseitigt hat</translation>
    </message>
    <message>
        <source>{count} of {count2} elements are not proven free of folds: {list}</source>
        <translation>{count} von {count2} Elementen sind nicht nachweislich frei von Falten: {list}</translation>
    </message>
    <message>
        <source>{list} and {count} more</source>
        <translation>{list} und {count} weitere</translation>
    </message>
    <message>
        <source>{name} has no faces (its type is {name2}): give a solid, a shell or faces</source>
        <translation>{name} hat keine Flächen (Art: {name2}): einen Körper, eine Hülle oder Flächen angeben</translation>
    </message>
    <message>
        <source>{name} has no triangles</source>
        <translation>{name} hat keine Dreiecke</translation>
    </message>
    <message>
        <source>{name} is null: it has no geometry</source>
        <translation>{name} ist leer: keine Geometrie</translation>
    </message>
    <message>
        <source>{name} is null: it has no geometry; recompute the document, if it is new</source>
        <translation>{name} ist leer: keine Geometrie; das Dokument neu berechnen, wenn es neu ist</translation>
    </message>
    <message>
        <source>{option}: {value} is not possible, it must be a number, {range}</source>
        <translation>{option}: {value} geht nicht, es muss eine Zahl sein, {range}</translation>
    </message>
    <message>
        <source>{option}: {value} is not possible, it must be a whole number, {range}</source>
        <translation>{option}: {value} geht nicht, es muss eine ganze Zahl sein, {range}</translation>
    </message>
    <message>
        <source>{option}: {value} is not possible, it must be {range}</source>
        <translation>{option}: {value} geht nicht, verlangt ist: {range}</translation>
    </message>
    <message>
        <source>{phrase} ({count} more triangles are below)</source>
        <translation>{phrase} ({count} weitere Dreiecke liegen darunter)</translation>
    </message>
    <message>
        <source>{phrase} at triangle {count}</source>
        <translation>{phrase} bei Dreieck {count}</translation>
    </message>
    <message>
        <source>{phrase} at {edge}</source>
        <translation>{phrase} an {edge}</translation>
    </message>
    <message>
        <source>{phrase} on {face}</source>
        <translation>{phrase} auf {face}</translation>
    </message>
    <message>
        <source>The same as a part of the shape&apos;s largest dimension: 0.001 is a thousandth</source>
        <translation>Dasselbe als Teil der größten Abmessung der Form: 0,001 ist ein Tausendstel</translation>
    </message>
    <message>
        <source>What is done with the operands, one after the other from the first on</source>
        <translation>Was mit den Operanden geschieht, nacheinander vom ersten an</translation>
    </message>
    <message>
        <source>60° is best; triangles of a few degrees spoil computations.</source>
        <translation>60° ist am besten; Dreiecke mit wenigen Grad verderben Berechnungen.</translation>
    </message>
    <message>
        <source>1 is best: all edges of a triangle are alike.</source>
        <translation>1 ist am besten: alle Kanten eines Dreiecks sind gleich.</translation>
    </message>
    <message>
        <source>How far each triangle is from the part that was meshed.</source>
        <translation>Wie weit jedes Dreieck vom vernetzten Teil entfernt ist.</translation>
    </message>
    <message>
        <source>How far an element is from equal sides and angles: 1 is best, 5 is poor, ∞ means that it folds over.</source>
        <translation>Wie weit ein Element von gleichen Seiten und Winkeln entfernt ist: 1 ist am besten, 5 ist schlecht, ∞ heißt, dass es umklappt.</translation>
    </message>
    <message>
        <source>How much an element is squeezed by its bending: 1 is as good as straight, 0 or less means that it folds over.</source>
        <translation>Wie sehr ein Element durch seine Krümmung gestaucht wird: 1 ist so gut wie gerade, 0 oder weniger heißt, dass es umklappt.</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>1: straight sides; 2: quadratic elements, which most FEM programs want; at most 5, with tetrahedra 4</source>
        <translation>1: gerade Seiten; 2: quadratische Elemente, wie die meisten FEM-Programme sie brauchen; höchstens 5, mit Tetraedern 4</translation>
    </message>
    <message>
        <source>Before curving</source>
        <translation>Vor dem Krümmen</translation>
    </message>
    <message>
        <source>Display accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Edges are sharp from</source>
        <translation>Kanten sind scharf ab</translation>
    </message>
    <message>
        <source>Into how many parts the longest side is cut: more parts follow the operands more closely and take longer. Gives the tolerance where that is 0</source>
        <translation>In wie viele Teile die längste Seite geteilt wird: mehr Teile folgen den Operanden genauer und dauern länger. Bestimmt die Toleranz, wo diese 0 ist</translation>
    </message>
    <message>
        <source>Or as a part of the size</source>
        <translation>Oder als Teil der Größe</translation>
    </message>
    <message>
        <source>the part itself has a corner of {number} degrees there, between {edge} and {edge2} at {vertex}</source>
        <translation>das Teil selbst hat dort eine Ecke von {number} Grad, zwischen {edge} und {edge2} bei {vertex}</translation>
    </message>
    <message>
        <source>5 million</source>
        <translation>5 Millionen</translation>
    </message>
    <message>
        <source>Work ends, incomplete, at this number</source>
        <translation>Die Arbeit endet unvollständig bei dieser Zahl</translation>
    </message>
    <message>
        <source>Stop computing</source>
        <translation>Berechnung abbrechen</translation>
    </message>
    <message>
        <source>A distance to the shape of {number} mm is finer than the numbers of a mesh in FreeCAD, which hold this part to {number2} mm: ask for more than that</source>
        <translation>Ein Abstand zur Form von {number} mm ist feiner, als die Zahlen eines Netzes in FreeCAD dieses Teil fassen ({number2} mm): mehr als das verlangen</translation>
    </message>
    <message>
        <source>A tolerance of {number} mm is finer than the numbers of a mesh in FreeCAD, which hold these operands to {number2} mm: ask for more than that</source>
        <translation>Eine Toleranz von {number} mm ist feiner, als die Zahlen eines Netzes in FreeCAD diese Operanden fassen ({number2} mm): mehr als das verlangen</translation>
    </message>
    <message>
        <source>Elements of order {count} are not possible with tetrahedra: it goes from 1 to {count2}</source>
        <translation>Elemente der Ordnung {count} gehen nicht mit Tetraedern: möglich ist 1 bis {count2}</translation>
    </message>
    <message>
        <source>Faces cannot be meshed: {value}. Repair the shape with Part - Check geometry, or choose under More options to leave such faces out</source>
        <translation>Flächen lassen sich nicht vernetzen: {value}. Die Form mit Part - Geometrie prüfen reparieren, oder unter Weitere Optionen solche Flächen auslassen</translation>
    </message>
    <message>
        <source>Shorter edges are asked for on {name}, but the shape has only {count} of these</source>
        <translation>Kürzere Kanten sind auf {name} verlangt, aber die Form hat davon nur {count}</translation>
    </message>
    <message>
        <source>The shape has no solids to fill with tetrahedra: switch that off to curve its faces</source>
        <translation>Die Form hat keine Körper, die mit Tetraedern zu füllen wären: dies abschalten, um ihre Flächen zu krümmen</translation>
    </message>
    <message>
        <source>The surface could not be filled with tetrahedra: it meets itself, or walls are too thin for its triangles. Ask for a smaller distance to the shape ({value})</source>
        <translation>Die Oberfläche ließ sich nicht mit Tetraedern füllen: sie trifft sich selbst, oder Wände sind zu dünn für ihre Dreiecke. Einen kleineren Abstand zur Form verlangen ({value})</translation>
    </message>
    <message>
        <source>The surface could not be filled with tetrahedra: its triangles do not fit each other across thin walls. Ask for a smaller distance to the shape or shorter edges</source>
        <translation>Die Oberfläche ließ sich nicht mit Tetraedern füllen: ihre Dreiecke passen über dünne Wände hinweg nicht zueinander. Einen kleineren Abstand zur Form oder kürzere Kanten verlangen</translation>
    </message>
    <message>
        <source>the shape has no faces with an area: give a solid, a shell or faces</source>
        <translation>die Form hat keine Flächen mit einem Inhalt: einen Körper, eine Hülle oder Flächen angeben</translation>
    </message>
    <message>
        <source>{name} has no triangle with an area that encloses a volume</source>
        <translation>{name} hat kein Dreieck mit einem Inhalt, das ein Volumen einschließt</translation>
    </message>
    <message>
        <source>Largest distance between the mesh and the shape before it is curved</source>
        <translation>Größter Abstand zwischen Netz und Form, bevor es gekrümmt wird</translation>
    </message>
    <message>
        <source>Longest edge of the mesh before it is curved</source>
        <translation>Längste Kante des Netzes, bevor es gekrümmt wird</translation>
    </message>
    <message>
        <source>Make those elements straight that fold over and cannot be repaired</source>
        <translation>Macht jene Elemente gerade, die umklappen und sich nicht reparieren lassen</translation>
    </message>
    <message>
        <source>No triangle gets a smaller angle than this, unless the part has a sharper corner; beyond about 30 many more triangles are needed</source>
        <translation>Kein Dreieck bekommt einen kleineren Winkel, außer wo das Teil selbst eine schärfere Ecke hat; über etwa 30 braucht es viel mehr Dreiecke</translation>
    </message>
    <message>
        <source>Smallest angle of the triangles before they are curved</source>
        <translation>Kleinster Winkel der Dreiecke, bevor sie gekrümmt werden</translation>
    </message>
    <message>
        <source>Distortion of the shape</source>
        <translation>Verzerrung der Form</translation>
    </message>
    <message>
        <source>separating faces that cross</source>
        <translation>Flächen, die sich schneiden, werden getrennt</translation>
    </message>
    <message>
        <source>Bent edges and faces get at least so many edges for each full turn: 12 to 36 is usual</source>
        <translation>Gebogene Kanten und Flächen erhalten mindestens so viele Dreieckskanten je volle Umdrehung: 12 bis 36 sind üblich</translation>
    </message>
    <message>
        <source>Edges on a full circle</source>
        <translation>Kanten je Vollkreis</translation>
    </message>
    <message>
        <source>Growth of edges</source>
        <translation>Wachstum der Kanten</translation>
    </message>
    <message>
        <source>How many times longer than their neighbours edges become on the way from fine places to coarse ones: 1.2 is slow, 2 is fast</source>
        <translation>Wievielmal so lang wie ihre Nachbarn Kanten auf dem Weg von feinen zu groben Stellen werden: 1,2 ist langsam, 2 ist schnell</translation>
    </message>
    <message>
        <source>Edges are smooth below</source>
        <translation>Kanten sind glatt unter</translation>
    </message>
    <message>
        <source>Edges of the shape</source>
        <translation>Kanten der Form</translation>
    </message>
    <message>
        <source>Which edges of the shape the mesh follows: all, or feature: not those that the surface crosses smoothly, which triangles then may span</source>
        <translation>Welchen Kanten der Form das Netz folgt: allen, oder nur scharfen: nicht denen, über die die Fläche glatt hinweggeht; über diese dürfen Dreiecke dann hinwegreichen</translation>
    </message>
    <message>
        <source>With keep_edges = feature: edges are smooth where the surface turns by less than this</source>
        <translation>Wenn nur scharfe Kanten bleiben: glatt sind Kanten, an denen sich die Fläche um weniger als dies dreht</translation>
    </message>
    <message>
        <source>keep all</source>
        <translation>alle behalten</translation>
    </message>
    <message>
        <source>keep sharp ones</source>
        <translation>scharfe behalten</translation>
    </message>
    <message>
        <source>no change of the triangles around makes the angle larger within the bounds</source>
        <translation>keine Änderung der Dreiecke ringsum macht den Winkel innerhalb der Grenzen größer</translation>
    </message>
    <message>
        <source>releasing smooth edges</source>
        <translation>glatte Kanten freigeben</translation>
    </message>
    <message>
        <source>taking out vertices</source>
        <translation>Überflüssige Punkte werden entfernt</translation>
    </message>
    <message>
        <source>MeshQuality computes in a binary, which must be made for {0}. None that can be used is here.</source>
        <translation>MeshQuality rechnet in einem Binärteil, der für {0} gemacht sein muss. Hier ist keiner, der sich benutzen lässt.</translation>
    </message>
    <message>
        <source>On Debian: install the package freecad-meshquality that was made for your release.</source>
        <translation>Unter Debian: das Paket freecad-meshquality installieren, das für die eigene Ausgabe gemacht wurde.</translation>
    </message>
    <message>
        <source>Elsewhere: unpack the archive of MeshQuality that was made for these versions in place of the folder {0}.</source>
        <translation>Anderswo: das Archiv von MeshQuality, das für diese Versionen gemacht wurde, an Stelle des Ordners {0} auspacken.</translation>
    </message>
    <message>
        <source>From these sources: run bash {0}</source>
        <translation>Aus diesen Quellen: bash {0} ausführen</translation>
    </message>
    <message>
        <source>From MeshQuality&apos;s sources: run bash tools/build in their folder.</source>
        <translation>Aus den Quellen von MeshQuality: in deren Ordner bash tools/build ausführen.</translation>
    </message>
    <message>
        <source>Then start FreeCAD again. Meshes that documents hold are shown meanwhile as they were saved.</source>
        <translation>Danach FreeCAD neu starten. Netze in Dokumenten werden bis dahin so gezeigt, wie sie gespeichert wurden.</translation>
    </message>
    <message>
        <source>no such angles fit beside edges that part by {number} degrees at {vertex}</source>
        <translation>neben Kanten, die bei {vertex} um {number} Grad auseinanderlaufen, passen keine solchen Winkel</translation>
    </message>
    <message>
        <source>so many triangles there had no room for a further point that it was not divided any finer</source>
        <translation>so viele Dreiecke hatten dort keinen Platz für einen weiteren Punkt, dass nicht feiner unterteilt wurde</translation>
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
    <message>
        <source>Meshes follow their source in the background</source>
        <translation>Netze folgen ihrer Quelle im Hintergrund</translation>
    </message>
    <message>
        <source>Otherwise the window waits until they are computed</source>
        <translation>Sonst wartet das Fenster, bis sie berechnet sind</translation>
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
    <name>MeshQuality_GetBinary</name>
    <message>
        <source>How to get the binary that MeshQuality needs for its work</source>
        <translation>Wie man den Binärteil bekommt, den MeshQuality für seine Arbeit braucht</translation>
    </message>
    <message>
        <source>What is missing...</source>
        <translation>Was fehlt...</translation>
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
    <name>MeshQuality_Quick</name>
    <message>
        <source>Mesh the selected shape at once, with the values used last, and show its quality in colour</source>
        <translation>Vernetzt die gewählte Form sofort mit den zuletzt benutzten Werten und zeigt ihre Qualität farbig</translation>
    </message>
    <message>
        <source>Quick mesh...</source>
        <translation>Schnelles Netz...</translation>
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
