<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>App::Property</name>
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
        <source>Largest angle of all triangles</source>
        <translation>Größter Winkel aller Dreiecke</translation>
    </message>
    <message>
        <source>Mean of that ratio over the elements</source>
        <translation>Mittel dieses Verhältnisses über die Elemente</translation>
    </message>
    <message>
        <source>Neighbouring triangles agree on outside</source>
        <translation>Benachbarte Dreiecke stimmen überein, wo außen ist</translation>
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
        <source>Refine after sampling, so that the bounds on angle and distance hold</source>
        <translation>Verfeinert nach dem Abtasten, damit die Schranken für Winkel und Abstand gelten</translation>
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
        <source>Smallest ratio of the least to the largest Jacobian of one element: 1 is best, 0 or less is invalid</source>
        <translation>Kleinstes Verhältnis der kleinsten zur größten Jacobi-Determinante eines Elements: 1 ist am besten, 0 oder weniger ist ungültig</translation>
    </message>
    <message>
        <source>The mesh has no edge of three or more triangles and no pinched vertex</source>
        <translation>Das Netz hat keine Kante mit drei oder mehr Dreiecken und keinen Punkt, in dem es sich nur berührt</translation>
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
        <source>What the colours of the elements show</source>
        <translation>Was die Farben der Elemente zeigen</translation>
    </message>
    <message>
        <source>Which elements are invalid</source>
        <translation>Welche Elemente ungültig sind</translation>
    </message>
    <message>
        <source>1: straight sides; 2: quadratic elements, which most FEM programs want; at most 5, with tetrahedra 4</source>
        <translation>1: gerade Seiten; 2: quadratische Elemente, wie die meisten FEM-Programme sie brauchen; höchstens 5, mit Tetraedern 4</translation>
    </message>
    <message>
        <source>Smallest angle of the triangles before they are curved</source>
        <translation>Kleinster Winkel der Dreiecke, bevor sie gekrümmt werden</translation>
    </message>
    <message>
        <source>With keep_edges = feature: edges are smooth where the surface turns by less than this</source>
        <translation>Wenn nur scharfe Kanten bleiben: glatt sind Kanten, an denen sich die Fläche um weniger als dies dreht</translation>
    </message>
    <message>
        <source>CAD edges to keep: all, or only sharp ones (feature); triangles may then cross smooth edges</source>
        <translation>CAD-Kanten, denen das Netz folgt: all oder feature; über glatte dürfen Dreiecke dann hinweggehen</translation>
    </message>
    <message>
        <source>Longest edge of a triangle; 0: unlimited</source>
        <translation>Längste Kante eines Dreiecks; 0: unbegrenzt</translation>
    </message>
    <message>
        <source>Longest edge of the mesh before it is curved; 0: unlimited</source>
        <translation>Längste Kante des Netzes vor dem Krümmen; 0: unbegrenzt</translation>
    </message>
    <message>
        <source>No edge is split into shorter ones than this; 0: unlimited</source>
        <translation>Keine Kante wird in kürzere als diese geteilt; 0: unbegrenzt</translation>
    </message>
    <message>
        <source>Random seed for the sprinkle method; the same seed gives the same mesh</source>
        <translation>Startwert des Zufalls für das Verfahren sprinkle; derselbe Wert gibt dasselbe Netz</translation>
    </message>
    <message>
        <source>Smallest angle that was requested</source>
        <translation>Kleinster verlangter Winkel</translation>
    </message>
    <message>
        <source>Stop at this number; the mesh is then incomplete; 0: 5 million</source>
        <translation>Bei dieser Anzahl aufhören; das Netz ist dann unvollständig; 0: 5 Millionen</translation>
    </message>
    <message>
        <source>The mesh is watertight: it has no open edge</source>
        <translation>Das Netz ist wasserdicht: es hat keine offene Kante</translation>
    </message>
    <message>
        <source>The path from each source to its operand, where only a link leads there: Part.Box.</source>
        <translation>Der Pfad von jeder Quelle zu ihrem Operanden, wo nur eine Verknüpfung dorthin führt: Part.Box.</translation>
    </message>
    <message>
        <source>The path from the source to what is meshed, where only a link leads there: Part.Box.</source>
        <translation>Der Pfad von der Quelle zu dem, was vernetzt wird, wo nur eine Verknüpfung dorthin führt: Part.Box.</translation>
    </message>
    <message>
        <source>Where the container of the first source stood when the mesh was computed</source>
        <translation>Wo der Behälter der ersten Quelle stand, als das Netz berechnet wurde</translation>
    </message>
    <message>
        <source>Where the origin of the triangles&apos; coordinates stood in the document then</source>
        <translation>Wo der Ursprung der Koordinaten der Dreiecke damals im Dokument stand</translation>
    </message>
    <message>
        <source>refine inserts points until every angle and distance fits; star (hexagons) and sprinkle (random points) first sample the faces, denser where they bend</source>
        <translation>refine fügt Punkte ein, bis jeder Winkel und Abstand passt; star (Sechsecke) und sprinkle (zufällige Punkte) tasten die Flächen zuerst ab, dichter wo sie sich biegen</translation>
    </message>
    <message>
        <source>A watertight mesh was requested, as the source is closed</source>
        <translation>Ein wasserdichtes Netz war verlangt, da die Quelle geschlossen ist</translation>
    </message>
    <message>
        <source>After an edit, faces that did not change keep their triangles, which is faster; undo gives the mesh that was there. Off: each mesh is computed from scratch, and depends on the shape and the options alone</source>
        <translation>Nach einer Änderung behalten Flächen, die gleich blieben, ihre Dreiecke, was schneller ist; Rückgängig gibt das frühere Netz. Aus: jedes Netz wird von Grund auf neu berechnet und hängt nur von Form und Optionen ab</translation>
    </message>
    <message>
        <source>Automatic: the mesh follows its sources and options; Manual: only Update mesh computes it again</source>
        <translation>Automatic: das Netz folgt seinen Quellen und Optionen; Manual: nur „Netz aktualisieren“ berechnet es neu</translation>
    </message>
    <message>
        <source>CAD faces on which a requested limit is not met</source>
        <translation>Flächen der Form, auf denen ein verlangter Grenzwert nicht eingehalten ist</translation>
    </message>
    <message>
        <source>Changes that were made</source>
        <translation>Änderungen am Netz</translation>
    </message>
    <message>
        <source>Corners of the triangle that is farthest from a requested limit</source>
        <translation>Ecken des Dreiecks, das einen verlangten Grenzwert am weitesten verfehlt</translation>
    </message>
    <message>
        <source>Digest of the source and the options of the elements</source>
        <translation>Prüfsumme der Quelle und der Optionen der Elemente</translation>
    </message>
    <message>
        <source>Digest of the sources and the options of this mesh</source>
        <translation>Prüfsumme der Quellen und der Optionen dieses Netzes</translation>
    </message>
    <message>
        <source>Edges where the surface turns by more than this are sharp and keep their place</source>
        <translation>Kanten, an denen sich die Fläche um mehr als dies dreht, sind scharf und bleiben an ihrem Ort</translation>
    </message>
    <message>
        <source>Elements that were straightened, as they stayed invalid</source>
        <translation>Elemente, die gerade gemacht wurden, weil sie ungültig blieben</translation>
    </message>
    <message>
        <source>Faces of the shape whose triangles were reused after the last edit</source>
        <translation>Flächen der Form, deren Dreiecke nach der letzten Änderung weiterverwendet wurden</translation>
    </message>
    <message>
        <source>How samples are connected: pseudo-delaunay in space, parametric in (u, v)</source>
        <translation>Wie Abtastpunkte verbunden werden: im Raum oder in den Parametern (u, v) der Fläche</translation>
    </message>
    <message>
        <source>Kinds of repairs, and the number of each</source>
        <translation>Arten von Reparaturen und ihre Anzahl</translation>
    </message>
    <message>
        <source>Largest deviation of an element from equal sides and angles: 1 is ideal, 5 is poor, infinite: folded</source>
        <translation>Größte Abweichung eines Elements von gleichen Seiten und Winkeln: 1 ist ideal, 5 schlecht, unendlich: umgeklappt</translation>
    </message>
    <message>
        <source>Largest distance between the given mesh and the improved one; 0: size / 1000</source>
        <translation>Größter Abstand zwischen dem gegebenen und dem verbesserten Netz; 0: Größe / 1000</translation>
    </message>
    <message>
        <source>Largest distance between the result and the exact Boolean; 0: by resolution</source>
        <translation>Größter Abstand zwischen dem Ergebnis und der exakten Verknüpfung; 0: nach Auflösung</translation>
    </message>
    <message>
        <source>Max. deviation of the elements from the shape</source>
        <translation>Max. Abweichung der Elemente von der Form</translation>
    </message>
    <message>
        <source>Max. deviation of the triangles shown from the elements</source>
        <translation>Max. Abweichung der gezeigten Dreiecke von den Elementen</translation>
    </message>
    <message>
        <source>Measured max. deviation from the shape</source>
        <translation>Gemessene max. Abweichung von der Form</translation>
    </message>
    <message>
        <source>Mesh the other faces where some fail; the report names those that were skipped</source>
        <translation>Misslingen einige Flächen, die übrigen vernetzen; der Bericht nennt die ausgelassenen</translation>
    </message>
    <message>
        <source>No triangle gets a smaller angle, except where the shape has a sharper corner; above 30 degrees many more triangles are needed</source>
        <translation>Kein Dreieck bekommt einen kleineren Winkel, außer wo die Form eine spitzere Ecke hat; über 30 Grad werden viel mehr Dreiecke gebraucht</translation>
    </message>
    <message>
        <source>Number of corners that repairs moved</source>
        <translation>Anzahl der Ecken, die Reparaturen verschoben haben</translation>
    </message>
    <message>
        <source>Number of elements that are not proven valid; 0 is required</source>
        <translation>Anzahl der Elemente, deren Gültigkeit nicht bewiesen ist; verlangt ist 0</translation>
    </message>
    <message>
        <source>Number of invalid elements before repair</source>
        <translation>Anzahl ungültiger Elemente vor der Reparatur</translation>
    </message>
    <message>
        <source>Order of the stored elements</source>
        <translation>Ordnung der gespeicherten Elemente</translation>
    </message>
    <message>
        <source>Other remarks about the computation</source>
        <translation>Weitere Bemerkungen zur Berechnung</translation>
    </message>
    <message>
        <source>Relative error of that volume against the volume of the shape; -1: the shape has none</source>
        <translation>Relativer Fehler dieses Volumens gegenüber dem der Form; -1: die Form hat keines</translation>
    </message>
    <message>
        <source>Repairs of the operands</source>
        <translation>Reparaturen an den Operanden</translation>
    </message>
    <message>
        <source>Requested max. deviation from the shape; 0: none</source>
        <translation>Verlangte max. Abweichung von der Form; 0: keine</translation>
    </message>
    <message>
        <source>Root mean square of that deviation</source>
        <translation>Quadratisches Mittel dieser Abweichung</translation>
    </message>
    <message>
        <source>Straighten the elements that stay invalid after all repairs; they deviate more from the shape</source>
        <translation>Elemente gerade machen, die nach allen Reparaturen ungültig bleiben; sie weichen mehr von der Form ab</translation>
    </message>
    <message>
        <source>Target for the smallest angle of every triangle</source>
        <translation>Ziel für den kleinsten Winkel jedes Dreiecks</translation>
    </message>
    <message>
        <source>Triangles taken unchanged from an operand</source>
        <translation>Dreiecke, die unverändert von einem Operanden stammen</translation>
    </message>
    <message>
        <source>Triangles that were created or changed</source>
        <translation>Dreiecke, die erzeugt oder geändert wurden</translation>
    </message>
    <message>
        <source>Volume that the elements enclose</source>
        <translation>Volumen, das die Elemente einschließen</translation>
    </message>
    <message>
        <source>Where a triangle with a small angle gets its new point: off-centre needs fewer triangles, circumcentre is the rule of Aftosmis 1999</source>
        <translation>Wo ein Dreieck mit kleinem Winkel seinen neuen Punkt bekommt: off-centre braucht weniger Dreiecke, circumcentre ist die Regel von Aftosmis 1999</translation>
    </message>
    <message>
        <source>Whether the mesh is up to date with its sources and options</source>
        <translation>Ob das Netz zu seinen Quellen und Optionen passt</translation>
    </message>
    <message>
        <source>Whether the mesh meets all requested limits; if not, which one is not met and where</source>
        <translation>Ob das Netz alle verlangten Grenzwerte einhält; wenn nicht, welchen nicht und wo</translation>
    </message>
    <message>
        <source>Growth rate of edge length from fine to coarse regions: 1.2 is slow, 2 is fast; 0: unlimited</source>
        <translation>Wachstumsrate der Kantenlänge von feinen zu groben Bereichen: 1,2 ist langsam, 2 schnell; 0: unbegrenzt</translation>
    </message>
    <message>
        <source>Largest distance between the flat triangles and the curved elements; 0: size / 1000</source>
        <translation>Größter Abstand zwischen den ebenen Dreiecken und den gekrümmten Elementen; 0: Größe / 1000</translation>
    </message>
    <message>
        <source>Smallest number of edges along each full turn of a curved edge or face: 12 to 36 is usual; 0: no minimum</source>
        <translation>Kleinste Anzahl der Kanten auf jeder vollen Umdrehung einer gekrümmten Kante oder Fläche: 12 bis 36 sind üblich; 0: kein Mindestwert</translation>
    </message>
    <message>
        <source>Set operation, applied to the operands in their order; difference: the first one without the others</source>
        <translation>Mengenoperation, der Reihe nach auf die Operanden angewandt; Differenz: der erste ohne die übrigen</translation>
    </message>
    <message>
        <source>How the containers of the other sources stood to that of the first one then</source>
        <translation>Wie die Behälter der anderen Quellen damals zu dem der ersten standen</translation>
    </message>
    <message>
        <source>Longest edge on single faces, along edges or around vertices: Face3=0.5 mm, Edge7=0.2 mm; in containers and links with the path to the object: Box.Face3=0.5 mm</source>
        <translation>Längste Kante auf einzelnen Flächen, entlang von Kanten oder um Ecken: Face3=0.5 mm, Edge7=0.2 mm; in Containern und Verknüpfungen mit dem Weg zum Objekt: Box.Face3=0.5 mm</translation>
    </message>
    <message>
        <source>For each reason in Exempt what it is made of, and the triangles, by which the window translates it</source>
        <translation>Zu jedem Grund in Exempt, woraus er besteht, und die Dreiecke; danach übersetzt ihn das Fenster</translation>
    </message>
    <message>
        <source>What the certificate is made of, by which the window translates it</source>
        <translation>Woraus das Zertifikat besteht; danach übersetzt es das Fenster</translation>
    </message>
    <message>
        <source>What a failure in Status is made of, by which the window translates it</source>
        <translation>Woraus ein Fehler in Status besteht; danach übersetzt ihn das Fenster</translation>
    </message>
    <message>
        <source>Join faces that belong to no shell, as those of most IGES files, where their borders lie together; the report says how far apart they were</source>
        <translation>Flächen ohne Hülle, wie die der meisten IGES-Dateien, verbinden, wo ihre Ränder aufeinanderliegen; der Bericht sagt, wie weit sie auseinanderlagen</translation>
    </message>
    <message>
        <source>1: straight sides; 2: quadratic elements, which follow curved faces and bend as they should</source>
        <translation>1: gerade Seiten; 2: quadratische Elemente, die gekrümmten Flächen folgen und sich richtig biegen</translation>
    </message>
    <message>
        <source>Fill the solids with tetrahedra; off, and where there is no solid: triangles for shells</source>
        <translation>Füllt die Körper mit Tetraedern; aus, und wo es keinen Körper gibt: Dreiecke für Schalen</translation>
    </message>
    <message>
        <source>The source, as FreeCAD&apos;s FEM workbench looks it up</source>
        <translation>Die Quelle, unter dem Namen, unter dem FreeCADs FEM-Arbeitsbereich sie sucht</translation>
    </message>
    <message>
        <source>Faces of patches that an edit of the source may have exchanged; choose them anew</source>
        <translation>Flächen von Patches, die eine Änderung der Quelle vertauscht haben kann; neu zu wählen</translation>
    </message>
    <message>
        <source>Give solids that share an area the same triangles on both sides, as analyses of assemblies need; the report names the pairs</source>
        <translation>Gibt Körpern, die sich in einer Fläche berühren, auf beiden Seiten dieselben Dreiecke, wie Analysen von Baugruppen sie brauchen; der Bericht nennt die Paare</translation>
    </message>
    <message>
        <source>Name of the patch of all other faces; empty: each is one by its own name</source>
        <translation>Name des Patches aller anderen Flächen; leer: jede ist einer mit ihrem eigenen Namen</translation>
    </message>
    <message>
        <source>Named groups of faces, one a line: &quot;inlet: Face1, Face4&quot;, or with a colour &quot;inlet #ff0000: Face1&quot;</source>
        <translation>Benannte Gruppen von Flächen, eine je Zeile: „inlet: Face1, Face4“, oder mit einer Farbe „inlet #ff0000: Face1“</translation>
    </message>
    <message>
        <source>A point inside of the closed surface, for snappyHexMesh</source>
        <translation>Ein Punkt im Innern der geschlossenen Oberfläche, für snappyHexMesh</translation>
    </message>
    <message>
        <source>The name of the patch that each face is</source>
        <translation>Der Name des Patches, der jede Fläche ist</translation>
    </message>
    <message>
        <source>The object whose mesh is taken</source>
        <translation>Das Objekt, dessen Netz genommen wird</translation>
    </message>
    <message>
        <source>Groups of the given mesh that this one has, too</source>
        <translation>Gruppen des gegebenen Netzes, die auch dieses hat</translation>
    </message>
    <message>
        <source>Number of elements of the given mesh</source>
        <translation>Anzahl der Elemente des gegebenen Netzes</translation>
    </message>
    <message>
        <source>Number of its elements that are not proven valid</source>
        <translation>Anzahl seiner Elemente, die nicht als gültig bewiesen sind</translation>
    </message>
    <message>
        <source>Number of its elements that others replace</source>
        <translation>Anzahl seiner Elemente, die durch andere ersetzt sind</translation>
    </message>
    <message>
        <source>Number of its vertices that are not where they were</source>
        <translation>Anzahl seiner Eckpunkte, die nicht mehr liegen, wo sie lagen</translation>
    </message>
    <message>
        <source>The object with the FEM mesh that is cured</source>
        <translation>Das Objekt mit dem FEM-Netz, das geheilt wird</translation>
    </message>
    <message>
        <source>Which these are</source>
        <translation>Welche das sind</translation>
    </message>
    <message>
        <source>Number of pairs of curved triangles that are neither proven to cross nor to be apart, as where bodies touch</source>
        <translation>Anzahl der Paare gekrümmter Dreiecke, bei denen weder bewiesen ist, dass sie sich kreuzen, noch dass sie getrennt sind, etwa wo sich Körper berühren</translation>
    </message>
    <message>
        <source>Number of pairs of curved triangles that cross</source>
        <translation>Anzahl der Paare gekrümmter Dreiecke, die sich kreuzen</translation>
    </message>
    <message>
        <source>Largest distance between neighbouring points that are measured; 0: size / 50</source>
        <translation>Größter Abstand benachbarter Punkte, an denen gemessen wird; 0: Größe / 50</translation>
    </message>
    <message>
        <source>Largest distance of the mesh that is measured from a shape; 0: by the thinnest wall</source>
        <translation>Größter Abstand des gemessenen Netzes von einer Form; 0: nach der dünnsten Wand</translation>
    </message>
    <message>
        <source>Measure the gaps and slots outside of each solid, in place of its walls</source>
        <translation>Statt der Wände die Spalte und Schlitze außerhalb jedes Körpers messen</translation>
    </message>
    <message>
        <source>Surfaces inclined to each other by more than this are a corner, not the sides of a wall</source>
        <translation>Flächen, die stärker gegeneinander geneigt sind, bilden eine Ecke und sind nicht die Seiten einer Wand</translation>
    </message>
    <message>
        <source>Walls thinner than this are reported; 0: no limit</source>
        <translation>Dünnere Wände werden gemeldet; 0: keine Grenze</translation>
    </message>
    <message>
        <source>spheres: diameter of the largest ball in the solid that touches the surface there; rays: along the inward normal to the other side</source>
        <translation>Kugeln: Durchmesser der größten Kugel im Körper, die die Oberfläche dort berührt; Strahlen: entlang der Normalen nach innen bis zur anderen Seite</translation>
    </message>
    <message>
        <source>Largest distance of the mesh that is measured from a shape; 0: size / 1000</source>
        <translation>Größter Abstand des gemessenen Netzes von einer Form; 0: Größe / 1000</translation>
    </message>
    <message>
        <source>Pairs of bodies farther from each other than this are left out; 0: no limit</source>
        <translation>Paare von Körpern, die weiter auseinander liegen, werden ausgelassen; 0: keine Grenze</translation>
    </message>
    <message>
        <source>Pairs of bodies nearer to each other than this are reported; 0: no limit</source>
        <translation>Paare von Körpern, die näher beieinander liegen, werden gemeldet; 0: keine Grenze</translation>
    </message>
    <message>
        <source>Draft that walls should have</source>
        <translation>Schräge, die Wände haben sollen</translation>
    </message>
    <message>
        <source>Faces of the shape that get no wall, so that the hollow reaches them; none: the hollow is closed</source>
        <translation>Flächen der Form, die keine Wand bekommen, so dass der Hohlraum bis zu ihnen reicht; keine: der Hohlraum ist geschlossen</translation>
    </message>
    <message>
        <source>How far the surface moves: outward, or inward where it is below 0</source>
        <translation>Wie weit sich die Oberfläche verschiebt: nach außen, bei Werten unter 0 nach innen</translation>
    </message>
    <message>
        <source>Number of triangles of the surface of the hollow</source>
        <translation>Anzahl der Dreiecke der Oberfläche des Hohlraums</translation>
    </message>
    <message>
        <source>Repairs of the source&apos;s mesh</source>
        <translation>Reparaturen am Netz der Quelle</translation>
    </message>
    <message>
        <source>The object whose solid is hollowed</source>
        <translation>Das Objekt, dessen Körper ausgehöhlt wird</translation>
    </message>
    <message>
        <source>The object whose solid is offset</source>
        <translation>Das Objekt, dessen Körper versetzt wird</translation>
    </message>
    <message>
        <source>Thickness of the wall, which grows inward from the surface</source>
        <translation>Dicke der Wand, die von der Oberfläche nach innen wächst</translation>
    </message>
    <message>
        <source>Threads that work at a time; 0: one for each core</source>
        <translation>Threads, die gleichzeitig arbeiten; 0: einer für jeden Kern</translation>
    </message>
    <message>
        <source>What the faces of the source were like when the openings were last right: their kinds, areas and centres</source>
        <translation>Wie die Flächen der Quelle waren, als die Öffnungen zuletzt stimmten: Art, Inhalt und Mittelpunkt</translation>
    </message>
    <message>
        <source>Largest distance between the result and the exact one, in both directions; unless given, a thousandth of the size, at most a tenth of the distance; 0: by size</source>
        <translation>Größter Abstand zwischen dem Ergebnis und dem exakten, in beiden Richtungen; ohne Angabe ein Tausendstel der Größe, höchstens ein Zehntel des Abstands; 0: nach Größe und Abstand</translation>
    </message>
    <message>
        <source>Area of the triangles that close gaps</source>
        <translation>Fläche der Dreiecke, die Lücken schließen</translation>
    </message>
    <message>
        <source>Largest distance between the wrap and the surfaces that it lies on, at most half of the gap; unless given, a quarter of the gap, at most a fiftieth of the size; 0: by size and gap</source>
        <translation>Größter Abstand zwischen der Hülle und den Flächen, auf denen sie liegt, höchstens die halbe Lücke; ohne Angabe ein Viertel der Lücke, höchstens ein Fünfzigstel der Größe; 0: nach Größe</translation>
    </message>
    <message>
        <source>Largest distance from the wrap of what sticks out of it</source>
        <translation>Größter Abstand dessen, was aus der Hülle herausragt, von ihr</translation>
    </message>
    <message>
        <source>Largest distance of the wrap from what it lies on, but for gaps</source>
        <translation>Größter Abstand der Hülle von dem, worauf sie liegt, außer an Lücken</translation>
    </message>
    <message>
        <source>Number of triangles that close gaps</source>
        <translation>Anzahl der Dreiecke, die Lücken schließen</translation>
    </message>
    <message>
        <source>One half of the mould opens along it, the other one against it</source>
        <translation>In diese Richtung öffnet sich eine Hälfte des Werkzeugs, die andere ihr entgegen</translation>
    </message>
    <message>
        <source>Pairs (index of a CAD face, number of successive triangles on it); -1: on none</source>
        <translation>Paare (Nummer einer CAD-Fläche, Anzahl der Dreiecke, die auf ihr aufeinander folgen); -1: auf keiner</translation>
    </message>
    <message>
        <source>The object that is measured</source>
        <translation>Das Objekt, an dem gemessen wird</translation>
    </message>
    <message>
        <source>What is measured: the thickness of walls, the distances between the solids of a shape, the draft against the pull direction of a mould, or cavities from which nothing comes out</source>
        <translation>Was gemessen wird: die Dicke der Wände, die Abstände zwischen den Körpern einer Form, die Entformungsschräge gegen die Öffnungsrichtung eines Werkzeugs, oder Hohlräume, aus denen nichts herauskommt</translation>
    </message>
    <message>
        <source>Area that neither half of the mould can leave</source>
        <translation>Fläche, von der sich keine Hälfte des Werkzeugs lösen kann</translation>
    </message>
    <message>
        <source>Area with less draft than the limit</source>
        <translation>Fläche mit weniger Schräge als verlangt</translation>
    </message>
    <message>
        <source>CAD faces where the minimum is, with too little draft or undercuts, or of voids</source>
        <translation>CAD-Flächen, an denen der kleinste Wert liegt, die zu wenig Schräge oder Hinterschneidungen haben, oder die der Hohlräume</translation>
    </message>
    <message>
        <source>Number of places below the limit (a wall has two sides), of pairs of solids that are too near or overlap, of voids</source>
        <translation>Anzahl der Stellen unter dem Grenzwert (eine Wand hat zwei Seiten), der Paare von Körpern, die einander zu nah sind oder sich überlappen, der Hohlräume</translation>
    </message>
    <message>
        <source>Smallest thickness, gap or clearance; 0 also where no two sides face each other</source>
        <translation>Kleinste Dicke, kleinster Spalt oder Abstand; 0 auch, wo keine zwei Seiten einander gegenüberstehen</translation>
    </message>
    <message>
        <source>Volume of all voids</source>
        <translation>Volumen aller Hohlräume</translation>
    </message>
    <message>
        <source>Largest distance of the mesh that is measured from a shape; 0: automatic</source>
        <translation>Größter Abstand des Netzes, an dem gemessen wird, von einer Form; 0: automatisch</translation>
    </message>
    <message>
        <source>Width of a ball that rolls over the objects from outside: openings narrower than this are closed</source>
        <translation>Durchmesser einer Kugel, die von außen über die Objekte rollt: engere Öffnungen werden geschlossen</translation>
    </message>
    <message>
        <source>The objects that are wrapped, with a mesh or a shape</source>
        <translation>Die Objekte, die umhüllt werden, mit einem Netz oder einer Form</translation>
    </message>
    <message>
        <source>Algorithm: exact divides triangles along the exact intersection; uniform samples along rays (Wang 2010), also operands that are open; default takes uniform where there is no exact result</source>
        <translation>Verfahren: Entweder werden Dreiecke längs der genauen Schnittlinie geteilt, oder die Körper, auch offene, werden längs Strahlen abgetastet (Wang 2010); voreingestellt ist das Abtasten nur, wo es kein genaues Ergebnis gibt</translation>
    </message>
    <message>
        <source>What the faces of the sources were like when the patches were last right: their kinds, areas and centres</source>
        <translation>Wie die Flächen der Quellen waren, als die Patches zuletzt stimmten: Arten, Inhalte und Mittelpunkte</translation>
    </message>
    <message>
        <source>Make the whole surface anew from the samples, so that no triangle of the operands stays; only with method uniform</source>
        <translation>Bildet die ganze Oberfläche neu aus den Abtastpunkten, so dass kein Dreieck der Körper bleibt; nur beim Abtasten</translation>
    </message>
    <message>
        <source>How curves and surfaces are evaluated: fast by formulas and polynomial pieces, native by OpenCASCADE alone, which takes longer</source>
        <translation>Wie Kurven und Flächen ausgewertet werden: fast durch Formeln und Polynomstücke, native nur durch OpenCASCADE, was länger dauert</translation>
    </message>
    <message>
        <source>Whether bodies of a shape that overlap, lie in one another or cross are a fault of the mesh, or allowed; the report names them</source>
        <translation>Ob Körper einer Form, die sich überlappen, ineinander liegen oder sich schneiden, ein Fehler des Netzes sind oder erlaubt; der Bericht nennt sie</translation>
    </message>
    <message>
        <source>Longest edge of the mesh before it is curved; 0: by the walls</source>
        <translation>Längste Kante des Netzes, bevor es gekrümmt wird; 0: nach den Wänden</translation>
    </message>
    <message>
        <source>Where no longest edge is given: elements through a wall of mean thickness, which is twice the volume over the area of the surface; at most about 100,000 elements in all</source>
        <translation>Wo keine längste Kante angegeben ist: Elemente durch eine Wand mittlerer Dicke, die das Doppelte des Volumens durch die Fläche der Oberfläche ist; im Ganzen höchstens etwa 100.000 Elemente</translation>
    </message>
    <message>
        <source>Largest distance between the repaired surface and the given one, but for holes that are closed; 0: size / 300</source>
        <translation>Größter Abstand zwischen der reparierten Oberfläche und der gegebenen, außer an Löchern, die geschlossen werden; 0: Größe / 300</translation>
    </message>
    <message>
        <source>The object whose mesh is repaired</source>
        <translation>Das Objekt, dessen Netz repariert wird</translation>
    </message>
    <message>
        <source>Pairs of solids that are too near or overlap, without a limit all, and how near: those that overlap, then the nearest ones, then those that touch</source>
        <translation>Paare von Körpern, die zu nahe sind oder sich überschneiden, ohne Grenze alle, und wie nahe: erst die sich überschneiden, dann die nächsten, dann die sich berühren</translation>
    </message>
    <message>
        <source>The colour of each triangle</source>
        <translation>Die Farbe jedes Dreiecks</translation>
    </message>
    <message>
        <source>Where walls below the limit are thinnest, without a limit the thinnest one; one point on each of the two solids of each line of Pairs; the centres of voids</source>
        <translation>Wo Wände unter der Grenze am dünnsten sind, ohne Grenze die dünnste; je ein Punkt auf den beiden Körpern jeder Zeile von Pairs; die Mittelpunkte von Hohlräumen</translation>
    </message>
    <message>
        <source>Cells along the longest side, or along 8 thicknesses of slender operands; sets the max. deviation if none is given</source>
        <translation>Zellen entlang der längsten Seite, bei schlanken Operanden entlang ihrer achtfachen Dicke; bestimmt die max. Abweichung, wenn keine angegeben ist</translation>
    </message>
    <message>
        <source>How the max. deviation from the shape is given: relative to its size, as a length, or not at all</source>
        <translation>Wie die max. Abweichung von der Form angegeben ist: relativ zu ihrer Größe, als Länge oder gar nicht</translation>
    </message>
    <message>
        <source>Max. deviation from the exact Boolean of the meshes</source>
        <translation>Max. Abweichung von der exakten Verknüpfung der Netze</translation>
    </message>
    <message>
        <source>Max. deviation from the shape, as a fraction of its largest dimension</source>
        <translation>Max. Abweichung von der Form, als Anteil an ihrer größten Abmessung</translation>
    </message>
    <message>
        <source>Max. deviation, measured and requested, with the digits that count: the editor shows 0.003 as 0.00</source>
        <translation>Max. Abweichung, gemessen und verlangt, mit den Stellen, auf die es ankommt: der Editor zeigt 0,003 als 0,00</translation>
    </message>
    <message>
        <source>Max. deviation: largest distance between the mesh and the shape, as a length</source>
        <translation>Max. Abweichung: größter Abstand zwischen Netz und Form, als Länge</translation>
    </message>
    <message>
        <source>Max. deviation: largest distance between the mesh before it is curved and the shape, as a length</source>
        <translation>Max. Abweichung: größter Abstand zwischen dem Netz vor dem Krümmen und der Form, als Länge</translation>
    </message>
    <message>
        <source>Max. deviation: the larger one of both distances, with that of the meshes of shapes</source>
        <translation>Max. Abweichung: der größere der beiden Abstände, mit dem der Netze von Formen</translation>
    </message>
    <message>
        <source>Proven max. deviation from the exact result, in both directions</source>
        <translation>Bewiesene max. Abweichung vom exakten Ergebnis, in beiden Richtungen</translation>
    </message>
    <message>
        <source>Requested max. deviation from the exact Boolean</source>
        <translation>Verlangte max. Abweichung von der exakten Verknüpfung</translation>
    </message>
    <message>
        <source>Requested max. deviation from the exact result, in both directions</source>
        <translation>Verlangte max. Abweichung vom exakten Ergebnis, in beiden Richtungen</translation>
    </message>
    <message>
        <source>Requested max. deviation of the wrap from what it lies on</source>
        <translation>Verlangte max. Abweichung der Hülle von dem, worauf sie liegt</translation>
    </message>
    <message>
        <source>Volume of a closed hollow, which is what it saves; 0 where it has openings</source>
        <translation>Volumen eines geschlossenen Hohlraums, das gespart wird; 0, wenn er Öffnungen hat</translation>
    </message>
    <message>
        <source>Number of triangles below the requested angle</source>
        <translation>Anzahl der Dreiecke unter dem verlangten Winkel</translation>
    </message>
    <message>
        <source>Triangles below the requested angle, and why; hidden where there are many</source>
        <translation>Dreiecke unter dem verlangten Winkel, und warum; verborgen, wo es viele sind</translation>
    </message>
    <message>
        <source>How the shape came from FreeCAD: live, in place, or stream, as a copy; empty: there was none</source>
        <translation>Wie die Form aus FreeCAD kam: live an Ort und Stelle, stream als Kopie; leer: es gab keine</translation>
    </message>
    <message>
        <source>How large they are there, and the nearest CAD face</source>
        <translation>Wie groß sie dort sind, und die nächste CAD-Fläche</translation>
    </message>
    <message>
        <source>Largest distance between the given mesh and the simplified one; 0: size / 1000</source>
        <translation>Größter Abstand zwischen dem gegebenen und dem vereinfachten Netz; 0: Größe / 1000</translation>
    </message>
    <message>
        <source>Number of points that were measured</source>
        <translation>Zahl der gemessenen Punkte</translation>
    </message>
    <message>
        <source>Percentage of the points within the tolerance; 100 without one</source>
        <translation>Anteil der Punkte innerhalb der Toleranz in Prozent; ohne Toleranz 100</translation>
    </message>
    <message>
        <source>Points farther from the reference than this, outside or inside, are reported; 0: no limit</source>
        <translation>Punkte, die außen oder innen weiter von der Referenz entfernt sind, werden gemeldet; 0: keine Grenze</translation>
    </message>
    <message>
        <source>Root mean square of the distances of the points that were aligned, without outliers</source>
        <translation>Quadratisches Mittel der Abstände der ausgerichteten Punkte, ohne Ausreißer</translation>
    </message>
    <message>
        <source>The deviation of each triangle, mm: the largest of its corners</source>
        <translation>Die Abweichung jedes Dreiecks in mm: die größte seiner Ecken</translation>
    </message>
    <message>
        <source>The largest deviation inside, below 0</source>
        <translation>Die größte Abweichung nach innen, kleiner als 0</translation>
    </message>
    <message>
        <source>The largest deviation outside</source>
        <translation>Die größte Abweichung nach außen</translation>
    </message>
    <message>
        <source>The largest distance of a point, outside or inside</source>
        <translation>Der größte Abstand eines Punkts, außen oder innen</translation>
    </message>
    <message>
        <source>The mean of all deviations</source>
        <translation>Das Mittel aller Abweichungen</translation>
    </message>
    <message>
        <source>The motion by which the points were aligned before</source>
        <translation>Die Bewegung, mit der die Punkte vorher ausgerichtet wurden</translation>
    </message>
    <message>
        <source>The root mean square of all deviations</source>
        <translation>Das quadratische Mittel aller Abweichungen</translation>
    </message>
    <message>
        <source>The scan, a mesh or a point cloud, and the part or mesh that it is measured against</source>
        <translation>Der Scan, ein Netz oder eine Punktwolke, und das Teil oder Netz, gegen das er gemessen wird</translation>
    </message>
    <message>
        <source>Where deviations are largest</source>
        <translation>Wo die Abweichungen am größten sind</translation>
    </message>
    <message>
        <source>none: points are measured where they are; near: they are fitted to the reference from there; any: from any pose, by principal axes first</source>
        <translation>none: Punkte werden dort gemessen, wo sie sind; near: sie werden von dort aus in die Referenz eingepasst; any: aus jeder Lage, zuerst nach den Hauptachsen</translation>
    </message>
    <message>
        <source>Every point of the mesh is at least this far from the surface of the part, on its side; proven</source>
        <translation>Jeder Punkt des Netzes ist mindestens so weit von der Oberfläche des Teils entfernt, auf seiner Seite; bewiesen</translation>
    </message>
    <message>
        <source>Largest distance between the mesh and the part, on one side of it</source>
        <translation>Größter Abstand zwischen dem Netz und dem Teil, auf einer Seite des Teils</translation>
    </message>
    <message>
        <source>No point of either surface is farther from the other one, proven</source>
        <translation>Kein Punkt einer der beiden Oberflächen ist weiter von der anderen entfernt, bewiesen</translation>
    </message>
    <message>
        <source>No point of the mesh is farther from the surface of the part; proven</source>
        <translation>Kein Punkt des Netzes ist weiter von der Oberfläche des Teils entfernt; bewiesen</translation>
    </message>
    <message>
        <source>Number of triangles of the given mesh</source>
        <translation>Anzahl der Dreiecke des gegebenen Netzes</translation>
    </message>
    <message>
        <source>The object whose solid is machined</source>
        <translation>Das Objekt, dessen Körper gefräst wird</translation>
    </message>
    <message>
        <source>outside: a tool that touches the mesh never cuts into the part; inside: the mesh never sticks out of it</source>
        <translation>Nie im Teil: ein Werkzeug, das das Netz berührt, schneidet nie in das Teil; nie außerhalb: das Netz ragt nie heraus</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>FarSize</source>
        <translation>Ferne Größe</translation>
    </message>
    <message>
        <source>Four indices of nodes each; of a sampled function its cells</source>
        <translation>Je vier Indizes von Knoten; bei einer abgetasteten Funktion ihre Zellen</translation>
    </message>
    <message>
        <source>Inside: in the solids; Near: within a distance of the faces, edges and points; Wake: where the solids go if they move along a direction</source>
        <translation>Inside: in den Volumenkörpern; Near: innerhalb eines Abstands von den Flächen, Kanten und Punkten; Wake: wohin die Volumenkörper kommen, wenn sie sich entlang einer Richtung bewegen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Lengths of edges by place: Size regions of the document, or files of points with columns x, y, z, size or of meshes with an array of sizes; the least of all holds</source>
        <translation>Kantenlängen nach Ort: Größenbereiche des Dokuments, oder Dateien von Punkten mit den Spalten x, y, z, size oder von Netzen mit einem Feld von Größen; die kleinste von allen gilt</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Places, three numbers each</source>
        <translation>Orte, je drei Zahlen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Sizes by node; of a sampled function by corner of its cells</source>
        <translation>Größen nach Knoten; bei einer abgetasteten Funktion nach Ecken ihrer Zellen</translation>
    </message>
    <message>
        <source>What the sizes were made of</source>
        <translation>Woraus die Größen gemacht wurden</translation>
    </message>
    <message>
        <source>Corners of faces below the smallest angle: keep them, each with one triangle of that angle; cut them off by a twentieth of the distance, where the faces beside them allow it; or do so (auto) where further triangles would be below the smallest angle</source>
        <translation>Ecken von Flächen unter dem kleinsten Winkel: behalten, jede mit einem Dreieck dieses Winkels; um ein Zwanzigstel des Abstands abschneiden, wo die Flächen daneben es zulassen; oder dies nur dort (auto), wo sonst weitere Dreiecke unter dem kleinsten Winkel lägen</translation>
    </message>
    <message>
        <source>Triangles with small angles get their points in rounds, which several threads share, or, with circumcentre, one after the other, the worst first, as in Aftosmis 1999</source>
        <translation>Dreiecke mit kleinen Winkeln bekommen ihre Punkte in Runden, die sich mehrere Threads teilen, oder, mit dem Umkreismittelpunkt, nacheinander, das schlechteste zuerst, wie in Aftosmis 1999</translation>
    </message>
    <message>
        <source>Both are at most this</source>
        <translation>Beide sind höchstens so groß</translation>
    </message>
    <message>
        <source>Estimated relative error of the strains at which the work ends</source>
        <translation>Geschätzter relativer Fehler der Dehnungen, bei dem die Arbeit endet</translation>
    </message>
    <message>
        <source>Most meshes that are made</source>
        <translation>Größte Zahl der Netze</translation>
    </message>
    <message>
        <source>No mesh is made that is expected to have more unknowns</source>
        <translation>Kein Netz wird erzeugt, das voraussichtlich mehr Unbekannte hat</translation>
    </message>
    <message>
        <source>Number of its faces on exact surfaces of the CAD; either this or FacetCount is 0</source>
        <translation>Anzahl seiner Flächen auf exakten Flächen des CAD; diese oder FacetCount ist 0</translation>
    </message>
    <message>
        <source>Number of its faces that are planar facets of the mesh</source>
        <translation>Anzahl seiner Flächen, die ebene Facetten des Netzes sind</translation>
    </message>
    <message>
        <source>The largest distance of the mesh from the solid, measured at points</source>
        <translation>Der größte Abstand des Netzes vom Festkörper, an Punkten gemessen</translation>
    </message>
    <message>
        <source>The largest distance of the solid from the mesh, measured at points</source>
        <translation>Der größte Abstand des Festkörpers vom Netz, an Punkten gemessen</translation>
    </message>
    <message>
        <source>The solid has planar facets where exact surfaces do not close; off: it is refused then</source>
        <translation>Der Festkörper hat ebene Facetten, wo exakte Flächen nicht schließen; aus: dann wird er abgelehnt</translation>
    </message>
    <message>
        <source>Volume of the mesh</source>
        <translation>Volumen des Netzes</translation>
    </message>
    <message>
        <source>Volume of the solid</source>
        <translation>Volumen des Festkörpers</translation>
    </message>
    <message>
        <source>Why it has facets, where it has</source>
        <translation>Warum er Facetten hat, falls er welche hat</translation>
    </message>
    <message>
        <source>By how much longer edges of tetrahedra get for each length of distance from the walls: 0.1 is slow, 0.8 is fast</source>
        <translation>Um wie viel länger Kanten von Tetraedern je Länge des Abstands von den Wänden werden: 0.1 ist langsam, 0.8 schnell</translation>
    </message>
    <message>
        <source>Coordinate of the plane of symmetry</source>
        <translation>Koordinate der Symmetrieebene</translation>
    </message>
    <message>
        <source>Faces of the part that get layers; none named: all. Layers end in the faces beside them, which must be planes</source>
        <translation>Flächen des Teils, die Schichten bekommen; keine genannt: alle. Schichten enden in den Flächen daneben, die eben sein müssen</translation>
    </message>
    <message>
        <source>For each wall the share of its area with all layers, and the height of the first one</source>
        <translation>Für jede Wand der Anteil ihrer Fläche mit allen Schichten und die Höhe der ersten</translation>
    </message>
    <message>
        <source>Groups of the mesh that are of no face of the part: the fluid and the far field</source>
        <translation>Gruppen des Netzes, die zu keiner Fläche des Teils gehören: das Fluid und das Fernfeld</translation>
    </message>
    <message>
        <source>Height of the layer on the wall</source>
        <translation>Höhe der Schicht an der Wand</translation>
    </message>
    <message>
        <source>How many times as high each layer is as the one before it</source>
        <translation>Wievielmal so hoch jede Schicht ist wie die vorige</translation>
    </message>
    <message>
        <source>How many times the largest dimension of the part the far field is away from it</source>
        <translation>Wie viele größte Abmessungen des Teils das Fernfeld von ihm entfernt ist</translation>
    </message>
    <message>
        <source>Kinds of elements, and the number of each</source>
        <translation>Arten von Elementen und ihre Anzahl</translation>
    </message>
    <message>
        <source>Largest angle between a face and the line through the centres beside it</source>
        <translation>Größter Winkel zwischen der Normale einer Seite und der Linie durch die Mitten daneben</translation>
    </message>
    <message>
        <source>Largest skewness of a face, as OpenFOAM measures it</source>
        <translation>Größte Schiefe einer Seite, wie OpenFOAM sie misst</translation>
    </message>
    <message>
        <source>Least scaled Jacobian of prisms and tetrahedra</source>
        <translation>Kleinste skalierte Jacobi-Determinante von Prismen und Tetraedern</translation>
    </message>
    <message>
        <source>Longest edges of triangles on the far field; unless given, a fifth of its distance; 0: by distance</source>
        <translation>Längste Kanten von Dreiecken auf dem Fernfeld; wenn nicht angegeben, ein Fünftel seines Abstands; 0: nach Abstand</translation>
    </message>
    <message>
        <source>Max. deviation of the surface from the part</source>
        <translation>Max. Abweichung der Oberfläche vom Teil</translation>
    </message>
    <message>
        <source>Number of layers of prisms on the walls</source>
        <translation>Anzahl der Schichten von Prismen an den Wänden</translation>
    </message>
    <message>
        <source>Number of nodes</source>
        <translation>Anzahl der Knoten</translation>
    </message>
    <message>
        <source>Number of volume elements</source>
        <translation>Anzahl der Volumenelemente</translation>
    </message>
    <message>
        <source>Numbers of the nodes of pyramids, which FreeCAD&apos;s files do not hold</source>
        <translation>Nummern der Knoten von Pyramiden, die FreeCADs Dateien nicht enthalten</translation>
    </message>
    <message>
        <source>Share of it with layers at least 0.95 times as high as asked for</source>
        <translation>Anteil davon mit Schichten, die mindestens 0,95-mal so hoch sind wie verlangt</translation>
    </message>
    <message>
        <source>Share of the area of the walls with all layers</source>
        <translation>Anteil der Fläche der Wände mit allen Schichten</translation>
    </message>
    <message>
        <source>The half-space of the fluid, whose plane is one of symmetry</source>
        <translation>Der Halbraum des Fluids, dessen Ebene eine Symmetrieebene ist</translation>
    </message>
    <message>
        <source>What the faces of the source were like when the walls were last right</source>
        <translation>Wie die Flächen der Quelle waren, als die Wände zuletzt stimmten</translation>
    </message>
    <message>
        <source>Where the fluid is: the part itself, or the space around it in a box or a sphere</source>
        <translation>Wo das Fluid ist: im Teil selbst oder im Raum darum in einem Quader oder einer Kugel</translation>
    </message>
    <message>
        <source>Longest length that a metric may want at a place, divided by the shortest</source>
        <translation>Größte Länge, die eine Metrik an einem Ort verlangen darf, geteilt durch die kleinste</translation>
    </message>
    <message>
        <source>Triangles that are stretched along the direction in which the surface bends least, so that fewer keep the distance; the largest angle is bounded by 150 degrees then, instead of the smallest one</source>
        <translation>Dreiecke, die in der Richtung gestreckt sind, in der sich die Fläche am wenigsten krümmt, so dass weniger die Abweichung einhalten; begrenzt ist dann der größte Winkel auf 150 Grad statt des kleinsten</translation>
    </message>
    <message>
        <source>1: straight sides; from 2 on layers follow the CAD</source>
        <translation>1: gerade Seiten; ab 2 folgen die Schichten dem CAD</translation>
    </message>
    <message>
        <source>Elements that bend less than the part, or not at all, to be valid</source>
        <translation>Elemente, die sich weniger als das Bauteil krümmen oder gar nicht, um gültig zu sein</translation>
    </message>
    <message>
        <source>Smallest min J / max |J| of an element, proven</source>
        <translation>Kleinstes min J / max |J| eines Elements, bewiesen</translation>
    </message>
</context>
<context>
    <name>MeshQuality</name>
    <message>
        <source>Show where</source>
        <translation>Zeigen, wo</translation>
    </message>
    <message>
        <source>The mesh is out of date: a source or an option has changed.</source>
        <translation>Das Netz ist veraltet: eine Quelle oder eine Option hat sich geändert.</translation>
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
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>No edge is split into shorter ones than this</source>
        <translation>Keine Kante wird in kürzere als diese geteilt</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
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
        <source>Very fine</source>
        <translation>Sehr fein</translation>
    </message>
    <message>
        <source>by resolution</source>
        <translation>nach Auflösung</translation>
    </message>
    <message>
        <source>exact intersection</source>
        <translation>genauer Schnitt</translation>
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
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Add the faces, edges and vertices that are selected in the 3D view</source>
        <translation>Die in der 3D-Ansicht ausgewählten Flächen, Kanten und Ecken hinzufügen</translation>
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
        <translation>Längste / kürzeste Kante</translation>
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
        <source>Draw edges</source>
        <translation>Kanten zeichnen</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Ärgste</translation>
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
        <source>a further point would fold the mesh</source>
        <translation>ein weiterer Punkt würde das Netz falten</translation>
    </message>
    <message>
        <source>a further point would make an edge shorter than the shortest that is allowed</source>
        <translation>ein weiterer Punkt würde eine Kante kürzer machen, als erlaubt ist</translation>
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
        <source>curving the surface</source>
        <translation>Oberfläche wird gekrümmt</translation>
    </message>
    <message>
        <source>dividing triangles</source>
        <translation>Dreiecke werden geteilt</translation>
    </message>
    <message>
        <source>filling with tetrahedra</source>
        <translation>Füllen mit Tetraedern</translation>
    </message>
    <message>
        <source>fitting to the shapes</source>
        <translation>Anpassen an die Formen</translation>
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
        <source>improving</source>
        <translation>Verbessern</translation>
    </message>
    <message>
        <source>its smallest angle lies between two sharp edges that must stay</source>
        <translation>sein kleinster Winkel liegt zwischen zwei scharfen Kanten, die bleiben müssen</translation>
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
        <source>meshing the shapes</source>
        <translation>Formen werden vernetzt</translation>
    </message>
    <message>
        <source>no change within the tolerance makes it better</source>
        <translation>keine Änderung innerhalb der max. Abweichung macht es besser</translation>
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
        <source>starting</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>tetrahedron {count} of {solid}</source>
        <translation>Tetraeder {count} von {solid}</translation>
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
        <source>{phrase} at {edge}</source>
        <translation>{phrase} an {edge}</translation>
    </message>
    <message>
        <source>{phrase} on {face}</source>
        <translation>{phrase} auf {face}</translation>
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
        <source>5 million</source>
        <translation>5 Millionen</translation>
    </message>
    <message>
        <source>Stop computing</source>
        <translation>Berechnung abbrechen</translation>
    </message>
    <message>
        <source>The shape has no solids to fill with tetrahedra: switch that off to curve its faces</source>
        <translation>Die Form hat keine Körper, die mit Tetraedern zu füllen wären: dies abschalten, um ihre Flächen zu krümmen</translation>
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
        <source>Longest edge of the mesh before it is curved</source>
        <translation>Längste Kante des Netzes, bevor es gekrümmt wird</translation>
    </message>
    <message>
        <source>Smallest angle of the triangles before they are curved</source>
        <translation>Kleinster Winkel der Dreiecke, bevor sie gekrümmt werden</translation>
    </message>
    <message>
        <source>separating faces that cross</source>
        <translation>Flächen, die sich schneiden, werden getrennt</translation>
    </message>
    <message>
        <source>With keep_edges = feature: edges are smooth where the surface turns by less than this</source>
        <translation>Wenn nur scharfe Kanten bleiben: glatt sind Kanten, an denen sich die Fläche um weniger als dies dreht</translation>
    </message>
    <message>
        <source>On Debian: install the package freecad-meshquality that was made for your release.</source>
        <translation>Unter Debian: das Paket freecad-meshquality installieren, das für die eigene Ausgabe gemacht wurde.</translation>
    </message>
    <message>
        <source>Elsewhere: unpack the file {0} of MeshQuality&apos;s release, which is a zip, into the folder {1}.</source>
        <translation>Anderswo: die Datei {0} der Veröffentlichung von MeshQuality, die ein Zip ist, in den Ordner {1} auspacken.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel “{}”; nothing is changed</source>
        <translation>„{}“ abbrechen; nichts wird geändert</translation>
    </message>
    <message>
        <source>waiting until the open task is closed</source>
        <translation>wartet, bis die geöffnete Aufgabe geschlossen ist</translation>
    </message>
    <message>
        <source>Target not met: {}</source>
        <translation>Ziel nicht erreicht: {}</translation>
    </message>
    <message>
        <source>All requested limits are met.</source>
        <translation>Alle verlangten Grenzen sind eingehalten.</translation>
    </message>
    <message>
        <source>The last update failed: {}</source>
        <translation>Die letzte Aktualisierung ist fehlgeschlagen: {}</translation>
    </message>
    <message>
        <source>The source was deleted. Close this panel.</source>
        <translation>Die Quelle wurde gelöscht. Schließen Sie dieses Fenster.</translation>
    </message>
    <message>
        <source>Mesh: {}, curved elements of order {}</source>
        <translation>Netz: {}, gekrümmte Elemente der Ordnung {}</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Choose a file, or type its name.</source>
        <translation>Wählen Sie eine Datei, oder geben Sie ihren Namen ein.</translation>
    </message>
    <message>
        <source>Source: {}</source>
        <translation>Quelle: {}</translation>
    </message>
    <message>
        <source>Continue in background</source>
        <translation>Im Hintergrund weiter</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Set all options to their defaults</source>
        <translation>Alle Optionen auf ihre Standardwerte setzen</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolut</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Unbegrenzt</translation>
    </message>
    <message>
        <source>Local sizes are for one object: open the panel for that object alone.</source>
        <translation>Lokale Größen gelten für ein einziges Objekt: Öffnen Sie das Fenster für dieses Objekt allein.</translation>
    </message>
    <message>
        <source>Not added: {0} is not part of {1}.</source>
        <translation>Nicht hinzugefügt: {0} ist kein Teil von {1}.</translation>
    </message>
    <message>
        <source>Select faces, edges or vertices of {} in the 3D view first.</source>
        <translation>Wählen Sie zuerst Flächen, Kanten oder Ecken von {} in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>60° is ideal; angles of a few degrees harm simulations.</source>
        <translation>60° sind ideal; Winkel von wenigen Grad schaden Simulationen.</translation>
    </message>
    <message>
        <source>Largest distance between each triangle and the source.</source>
        <translation>Größter Abstand jedes Dreiecks von der Quelle.</translation>
    </message>
    <message>
        <source>Shape distortion</source>
        <translation>Verzerrung der Form</translation>
    </message>
    <message>
        <source>Deviation from equal sides and angles: 1 = ideal, 5 = poor, ∞ = folded.</source>
        <translation>Abweichung von gleichen Seiten und Winkeln: 1 = ideal, 5 = schlecht, ∞ = umgeklappt.</translation>
    </message>
    <message>
        <source>1 = undistorted by its curvature, ≤ 0 = invalid.</source>
        <translation>1 = durch die Krümmung nicht verzerrt, ≤ 0 = ungültig.</translation>
    </message>
    <message>
        <source>Mesh: {0}</source>
        <translation>Netz: {0}</translation>
    </message>
    <message>
        <source>{0} tetrahedra: worst {1}, mean {2}</source>
        <translation>{0} Tetraeder: schlechtester {1}, Mittel {2}</translation>
    </message>
    <message>
        <source>Shown are the {0} at the surface: worst {1}, mean {2}</source>
        <translation>Gezeigt sind die {0} an der Oberfläche: schlechtester {1}, Mittel {2}</translation>
    </message>
    <message>
        <source>{0} triangles: worst {1}, mean {2}</source>
        <translation>{0} Dreiecke: schlechtestes {1}, Mittel {2}</translation>
    </message>
    <message>
        <source>1 element</source>
        <translation>1 Element</translation>
    </message>
    <message>
        <source>1 face could not be meshed and was left out: {list}.</source>
        <translation>1 Fläche konnte nicht vernetzt werden und wurde ausgelassen: {list}.</translation>
    </message>
    <message>
        <source>1 fault remains that no repair removed.</source>
        <translation>1 Fehler bleibt, den keine Reparatur behoben hat.</translation>
    </message>
    <message>
        <source>1 more element is distorted by more than {number}.</source>
        <translation>1 weiteres Element ist um mehr als {number} verzerrt.</translation>
    </message>
    <message>
        <source>1 more triangle is below {number}°, at a small corner of the shape too.</source>
        <translation>1 weiteres Dreieck liegt unter {number}°, auch dieses an einer spitzen Ecke der Form.</translation>
    </message>
    <message>
        <source>1 more triangle is below {number}°.</source>
        <translation>1 weiteres Dreieck liegt unter {number}°.</translation>
    </message>
    <message>
        <source>1 of {count2} elements is not proven valid: {list}.</source>
        <translation>1 von {count2} Elementen ist nicht als gültig bewiesen: {list}.</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 Dreieck</translation>
    </message>
    <message>
        <source>1 triangle has no area.</source>
        <translation>1 Dreieck hat keine Fläche.</translation>
    </message>
    <message>
        <source>CAD edges to keep: all, or only sharp ones (feature); triangles may then cross smooth edges</source>
        <translation>CAD-Kanten, denen das Netz folgt: all oder feature; über glatte dürfen Dreiecke dann hinweggehen</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Edges per full circle</source>
        <translation>Kanten je Vollkreis</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Kantenwinkel</translation>
    </message>
    <message>
        <source>Growth rate</source>
        <translation>Wachstumsrate</translation>
    </message>
    <message>
        <source>Growth rate of edge length from fine to coarse regions: 1.2 is slow, 2 is fast</source>
        <translation>Wachstumsrate der Kantenlänge von feinen zu groben Bereichen: 1,2 ist langsam, 2 schnell</translation>
    </message>
    <message>
        <source>Intersection</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>Local sizes</source>
        <translation>Lokale Größen</translation>
    </message>
    <message>
        <source>Max. deviation</source>
        <translation>Max. Abweichung</translation>
    </message>
    <message>
        <source>Random seed for the sprinkle method; the same seed gives the same mesh</source>
        <translation>Startwert des Zufalls für das Verfahren „zufällig abtasten“; derselbe Wert gibt dasselbe Netz</translation>
    </message>
    <message>
        <source>Relative deviation</source>
        <translation>Relative Abweichung</translation>
    </message>
    <message>
        <source>Smallest number of edges along each full turn of a curved edge or face: 12 to 36 is usual</source>
        <translation>Kleinste Anzahl der Kanten auf jeder vollen Umdrehung einer gekrümmten Kante oder Fläche: 12 bis 36 sind üblich</translation>
    </message>
    <message>
        <source>Source is empty: the source was deleted; choose another one, or delete this mesh</source>
        <translation>Source ist leer: Die Quelle wurde gelöscht; wählen Sie eine andere, oder löschen Sie dieses Netz</translation>
    </message>
    <message>
        <source>Sources has 1 object: choose two or more with a mesh or a shape</source>
        <translation>Sources enthält 1 Objekt: Wählen Sie zwei oder mehr mit einem Netz oder einer Form</translation>
    </message>
    <message>
        <source>Stop at this number; the mesh is then incomplete</source>
        <translation>Bei dieser Anzahl aufhören; das Netz ist dann unvollständig</translation>
    </message>
    <message>
        <source>Straighten invalid elements</source>
        <translation>Ungültige begradigen</translation>
    </message>
    <message>
        <source>Symmetric difference</source>
        <translation>Symmetrische Differenz</translation>
    </message>
    <message>
        <source>The document was closed. Close this panel.</source>
        <translation>Das Dokument wurde geschlossen. Schließen Sie dieses Fenster.</translation>
    </message>
    <message>
        <source>Triangle limit</source>
        <translation>Höchstzahl der Dreiecke</translation>
    </message>
    <message>
        <source>Union</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <source>a further point would lie closer to its neighbours than they do to each other</source>
        <translation>ein weiterer Punkt läge näher an seinen Nachbarn als diese aneinander</translation>
    </message>
    <message>
        <source>all requested limits are met.</source>
        <translation>alle verlangten Grenzen sind eingehalten.</translation>
    </message>
    <message>
        <source>edges at the narrow corner of the shape would become ever shorter at {vertex}</source>
        <translation>Kanten an der spitzen Ecke der Form würden bei {vertex} immer kürzer</translation>
    </message>
    <message>
        <source>edges of the shape that meet at {number}° leave no room for larger angles at {vertex}</source>
        <translation>Kanten der Form, die sich bei {vertex} unter {number}° treffen, lassen keinen Platz für größere Winkel</translation>
    </message>
    <message>
        <source>local_sizes names {value}, but {name} does not hold that: select it again in the 3D view</source>
        <translation>Lokale Größen nennen {value}, das gehört aber nicht zu {name}: Wählen Sie es in der 3D-Ansicht neu</translation>
    </message>
    <message>
        <source>max. shape distortion {number}</source>
        <translation>größte Formverzerrung {number}</translation>
    </message>
    <message>
        <source>max. shape distortion {number} (limit {number2}), {phrase}.</source>
        <translation>größte Formverzerrung {number} (Grenze {number2}), {phrase}.</translation>
    </message>
    <message>
        <source>no change of the triangles around it makes the angle larger within the limits</source>
        <translation>keine Änderung der umliegenden Dreiecke vergrößert den Winkel innerhalb der Grenzen</translation>
    </message>
    <message>
        <source>no point of the surface was found there</source>
        <translation>dort wurde kein Punkt der Oberfläche gefunden</translation>
    </message>
    <message>
        <source>not manifold: 1 edge has three or more triangles.</source>
        <translation>nicht mannigfaltig: 1 Kante hat drei oder mehr Dreiecke.</translation>
    </message>
    <message>
        <source>not manifold: the surface only touches itself at 1 vertex.</source>
        <translation>nicht mannigfaltig: Die Oberfläche berührt sich an 1 Punkt nur.</translation>
    </message>
    <message>
        <source>not manifold: the surface only touches itself at {count} vertices.</source>
        <translation>nicht mannigfaltig: Die Oberfläche berührt sich an {count} Punkten nur.</translation>
    </message>
    <message>
        <source>not manifold: {count} edges have three or more triangles.</source>
        <translation>nicht mannigfaltig: {count} Kanten haben drei oder mehr Dreiecke.</translation>
    </message>
    <message>
        <source>not watertight: 1 open edge.</source>
        <translation>nicht wasserdicht: 1 offene Kante.</translation>
    </message>
    <message>
        <source>not watertight: {count} open edges.</source>
        <translation>nicht wasserdicht: {count} offene Kanten.</translation>
    </message>
    <message>
        <source>points cannot be placed any closer in single precision</source>
        <translation>Punkte können in einfacher Genauigkeit nicht näher beieinander liegen</translation>
    </message>
    <message>
        <source>refine inserts points until every angle and distance fits; star (hexagons) and sprinkle (random points) first sample the faces, denser where they bend</source>
        <translation>Verfeinern fügt Punkte ein, bis jeder Winkel und Abstand passt; Abtasten (in Sechsecken oder zufällig) setzt zuerst Punkte auf die Flächen, dichter wo sie sich biegen</translation>
    </message>
    <message>
        <source>smallest angle {number}°</source>
        <translation>kleinster Winkel {number}°</translation>
    </message>
    <message>
        <source>smallest angle {number}° (requested {number2}°), {phrase}.</source>
        <translation>kleinster Winkel {number}° (verlangt {number2}°), {phrase}.</translation>
    </message>
    <message>
        <source>target angle not reachable: {phrase}.</source>
        <translation>Zielwinkel nicht erreichbar: {phrase}.</translation>
    </message>
    <message>
        <source>target not met: {text}</source>
        <translation>Ziel nicht erreicht: {text}</translation>
    </message>
    <message>
        <source>the mesh is incomplete: a limit ended the work early</source>
        <translation>das Netz ist unvollständig: Eine Grenze hat die Arbeit vorzeitig beendet</translation>
    </message>
    <message>
        <source>the shape itself has a corner of {number}° between {edge} and {edge2} at {vertex}</source>
        <translation>die Form selbst hat eine Ecke von {number}° zwischen {edge} und {edge2} bei {vertex}</translation>
    </message>
    <message>
        <source>the surface comes to a point with too little angle around it at {vertex}</source>
        <translation>die Oberfläche läuft bei {vertex} in eine Spitze mit zu wenig Winkel um sie herum aus</translation>
    </message>
    <message>
        <source>the surface intersects itself: 1 pair of triangles crosses.</source>
        <translation>die Oberfläche durchdringt sich selbst: 1 Paar von Dreiecken kreuzt sich.</translation>
    </message>
    <message>
        <source>the surface intersects itself: more than {count} pairs of triangles cross.</source>
        <translation>die Oberfläche durchdringt sich selbst: Mehr als {count} Paare von Dreiecken kreuzen sich.</translation>
    </message>
    <message>
        <source>the surface intersects itself: {count} pairs of triangles cross.</source>
        <translation>die Oberfläche durchdringt sich selbst: {count} Paare von Dreiecken kreuzen sich.</translation>
    </message>
    <message>
        <source>the triangle limit was reached</source>
        <translation>die Höchstzahl der Dreiecke wurde erreicht</translation>
    </message>
    <message>
        <source>the triangles on both sides of 1 edge disagree on the outside.</source>
        <translation>die Dreiecke beiderseits 1 Kante sind sich nicht einig, wo außen ist.</translation>
    </message>
    <message>
        <source>the triangles on both sides of {count} edges disagree on the outside.</source>
        <translation>die Dreiecke beiderseits von {count} Kanten sind sich nicht einig, wo außen ist.</translation>
    </message>
    <message>
        <source>too many triangles there have no room for a further point, so the face is refined no further</source>
        <translation>zu viele Dreiecke haben dort keinen Platz für einen weiteren Punkt, daher wird die Fläche nicht weiter verfeinert</translation>
    </message>
    <message>
        <source>triangle {count}</source>
        <translation>Dreieck {count}</translation>
    </message>
    <message>
        <source>unlimited</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>{count} elements</source>
        <translation>{count} Elemente</translation>
    </message>
    <message>
        <source>{count} faces could not be meshed and were left out: {list}.</source>
        <translation>{count} Flächen konnten nicht vernetzt werden und wurden ausgelassen: {list}.</translation>
    </message>
    <message>
        <source>{count} faults remain that no repair removed.</source>
        <translation>{count} Fehler bleiben, die keine Reparatur behoben hat.</translation>
    </message>
    <message>
        <source>{count} more elements are distorted by more than {number}.</source>
        <translation>{count} weitere Elemente sind um mehr als {number} verzerrt.</translation>
    </message>
    <message>
        <source>{count} more triangles are below {number}°, all of them at small corners of the shape.</source>
        <translation>{count} weitere Dreiecke liegen unter {number}°, alle an spitzen Ecken der Form.</translation>
    </message>
    <message>
        <source>{count} more triangles are below {number}°.</source>
        <translation>{count} weitere Dreiecke liegen unter {number}°.</translation>
    </message>
    <message>
        <source>{count} of {count2} elements are not proven valid: {list}.</source>
        <translation>{count} von {count2} Elementen sind nicht als gültig bewiesen: {list}.</translation>
    </message>
    <message>
        <source>{count} triangles</source>
        <translation>{count} Dreiecke</translation>
    </message>
    <message>
        <source>{count} triangles have no area.</source>
        <translation>{count} Dreiecke haben keine Fläche.</translation>
    </message>
    <message>
        <source>{face} and {face2} cross.</source>
        <translation>{face} und {face2} kreuzen sich.</translation>
    </message>
    <message>
        <source>{face} crosses itself.</source>
        <translation>{face} durchdringt sich selbst.</translation>
    </message>
    <message>
        <source>MeshQuality needs a binary file made for {0}. No usable one was found.</source>
        <translation>MeshQuality braucht eine Binärdatei, die für {0} gemacht ist. Es wurde keine brauchbare gefunden.</translation>
    </message>
    <message>
        <source>From these sources: run ‘bash {0}’ in a terminal.</source>
        <translation>Aus diesen Quellen: in einem Terminal „bash {0}“ ausführen.</translation>
    </message>
    <message>
        <source>From MeshQuality's sources: run ‘bash tools/build’ in their folder.</source>
        <translation>Aus den Quellen von MeshQuality: in ihrem Ordner „bash tools/build“ ausführen.</translation>
    </message>
    <message>
        <source>Then restart FreeCAD. Until then, meshes of your documents are shown as they were saved.</source>
        <translation>Danach FreeCAD neu starten. Bis dahin werden Netze in Ihren Dokumenten so gezeigt, wie sie gespeichert wurden.</translation>
    </message>
    <message>
        <source>Update the mesh to check whether all requested limits are met.</source>
        <translation>Aktualisieren Sie das Netz, um zu prüfen, ob es alle verlangten Grenzwerte einhält.</translation>
    </message>
    <message>
        <source>Moves the camera there, and selects the faces of the shape on which a requested limit is not met</source>
        <translation>Führt die Kamera dorthin und wählt die Flächen der Form aus, auf denen ein verlangter Grenzwert nicht eingehalten ist</translation>
    </message>
    <message>
        <source>Without an extension, that of the format is added</source>
        <translation>Fehlt die Dateiendung, wird die des Formats ergänzt</translation>
    </message>
    <message>
        <source>Computes the mesh and leaves the panel open</source>
        <translation>Berechnet das Netz und lässt den Aufgabenbereich offen</translation>
    </message>
    <message>
        <source>Closes the panel; the status bar shows the progress and can cancel the work</source>
        <translation>Schließt den Aufgabenbereich; die Statusleiste zeigt den Fortschritt und kann die Arbeit abbrechen</translation>
    </message>
    <message>
        <source>The triangles are counted when other work has finished.</source>
        <translation>Die Dreiecke werden gezählt, wenn andere Arbeit beendet ist.</translation>
    </message>
    <message>
        <source>Measuring starts when other work has finished.</source>
        <translation>Gemessen wird, wenn andere Arbeit beendet ist.</translation>
    </message>
    <message>
        <source>Red: the largest distance of this mesh.</source>
        <translation>Rot: der größte Abstand dieses Netzes.</translation>
    </message>
    <message>
        <source>Red: more than the requested {0}.</source>
        <translation>Rot: mehr als die verlangten {0}.</translation>
    </message>
    <message>
        <source>Click to move the camera there</source>
        <translation>Klicken, um die Kamera dorthin zu führen</translation>
    </message>
    <message>
        <source>CAD edges to keep</source>
        <translation>Kanten der Form beibehalten</translation>
    </message>
    <message>
        <source>Connect samples</source>
        <translation>Abtastpunkte verbinden</translation>
    </message>
    <message>
        <source>Edges where the surface turns by more than this are sharp and keep their place</source>
        <translation>Kanten, an denen sich die Fläche um mehr als dies dreht, sind scharf und bleiben an ihrem Ort</translation>
    </message>
    <message>
        <source>Element order</source>
        <translation>Ordnung der Elemente</translation>
    </message>
    <message>
        <source>Faces cannot be meshed: {value}. Repair the shape (Part - Check geometry), or choose to skip faces that fail under More options</source>
        <translation>Flächen lassen sich nicht vernetzen: {value}. Reparieren Sie die Form (Part - Geometrie überprüfen), oder wählen Sie unter „Weitere Optionen“, misslungene Flächen auszulassen</translation>
    </message>
    <message>
        <source>How samples are connected: pseudo-delaunay in space, parametric in (u, v)</source>
        <translation>Wie Abtastpunkte verbunden werden: im Raum oder in den Parametern (u, v) der Fläche</translation>
    </message>
    <message>
        <source>Largest distance between the given mesh and the improved one</source>
        <translation>Größter Abstand zwischen dem gegebenen und dem verbesserten Netz</translation>
    </message>
    <message>
        <source>Largest distance between the result and the exact Boolean</source>
        <translation>Größter Abstand zwischen dem Ergebnis und der exakten Verknüpfung</translation>
    </message>
    <message>
        <source>Mesh the other faces where some fail; the report names those that were skipped</source>
        <translation>Misslingen einige Flächen, die übrigen vernetzen; der Bericht nennt die ausgelassenen</translation>
    </message>
    <message>
        <source>No triangle gets a smaller angle, except where the shape has a sharper corner; above 30 degrees many more triangles are needed</source>
        <translation>Kein Dreieck bekommt einen kleineren Winkel, außer wo die Form eine spitzere Ecke hat; über 30 Grad werden viel mehr Dreiecke gebraucht</translation>
    </message>
    <message>
        <source>Point insertion</source>
        <translation>Einfügen von Punkten</translation>
    </message>
    <message>
        <source>Skip faces that fail</source>
        <translation>Misslungene Flächen auslassen</translation>
    </message>
    <message>
        <source>Straighten the elements that stay invalid after all repairs; they deviate more from the shape</source>
        <translation>Elemente gerade machen, die nach allen Reparaturen ungültig bleiben; sie weichen mehr von der Form ab</translation>
    </message>
    <message>
        <source>Target for the smallest angle of every triangle</source>
        <translation>Ziel für den kleinsten Winkel jedes Dreiecks</translation>
    </message>
    <message>
        <source>Tetrahedra of order {count} are not possible: choose an order from 1 to {count2}</source>
        <translation>Tetraeder der Ordnung {count} sind nicht möglich: wählen Sie eine Ordnung von 1 bis {count2}</translation>
    </message>
    <message>
        <source>The surface could not be filled with tetrahedra: it intersects itself, or walls are too thin for its triangles. Choose a smaller max. deviation ({value})</source>
        <translation>Die Oberfläche ließ sich nicht mit Tetraedern füllen: sie schneidet sich selbst, oder Wände sind zu dünn für ihre Dreiecke. Wählen Sie eine kleinere max. Abweichung ({value})</translation>
    </message>
    <message>
        <source>Where a triangle with a small angle gets its new point: off-centre needs fewer triangles, circumcentre is the rule of Aftosmis 1999</source>
        <translation>Wo ein Dreieck mit kleinem Winkel seinen neuen Punkt bekommt: neben der Umkreismitte braucht weniger Dreiecke, in der Umkreismitte ist die Regel von Aftosmis 1999</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>assembling the result</source>
        <translation>Ergebnis wird zusammengesetzt</translation>
    </message>
    <message>
        <source>building the octree</source>
        <translation>Octree wird aufgebaut</translation>
    </message>
    <message>
        <source>building the surface</source>
        <translation>Oberfläche wird aufgebaut</translation>
    </message>
    <message>
        <source>checking the operands</source>
        <translation>Operanden werden geprüft</translation>
    </message>
    <message>
        <source>circumcentre</source>
        <translation>Umkreismitte</translation>
    </message>
    <message>
        <source>classifying the triangles</source>
        <translation>Dreiecke werden zugeordnet</translation>
    </message>
    <message>
        <source>clustering the samples</source>
        <translation>Abtastpunkte werden gruppiert</translation>
    </message>
    <message>
        <source>combining the samples</source>
        <translation>Abtastpunkte werden verknüpft</translation>
    </message>
    <message>
        <source>dividing into triangles</source>
        <translation>Zerlegung in Dreiecke</translation>
    </message>
    <message>
        <source>extracting the result</source>
        <translation>Ergebnis wird herausgelöst</translation>
    </message>
    <message>
        <source>finding inside and outside</source>
        <translation>Innen und Außen werden bestimmt</translation>
    </message>
    <message>
        <source>finding intersections</source>
        <translation>Schnitte werden gesucht</translation>
    </message>
    <message>
        <source>improving the remaining triangles</source>
        <translation>übrige Dreiecke werden verbessert</translation>
    </message>
    <message>
        <source>initial triangulation</source>
        <translation>erste Triangulierung</translation>
    </message>
    <message>
        <source>off-centre</source>
        <translation>neben der Umkreismitte</translation>
    </message>
    <message>
        <source>only sharp ones</source>
        <translation>nur scharfe</translation>
    </message>
    <message>
        <source>refining angles</source>
        <translation>Winkel werden verfeinert</translation>
    </message>
    <message>
        <source>refining to the max. deviation</source>
        <translation>Verfeinern bis zur max. Abweichung</translation>
    </message>
    <message>
        <source>removing smooth edges</source>
        <translation>glatte Kanten werden entfernt</translation>
    </message>
    <message>
        <source>removing vertices</source>
        <translation>Eckpunkte werden entfernt</translation>
    </message>
    <message>
        <source>sampling the faces of the shapes</source>
        <translation>Flächen der Formen werden abgetastet</translation>
    </message>
    <message>
        <source>sampling the surface</source>
        <translation>Oberfläche wird abgetastet</translation>
    </message>
    <message>
        <source>separating contacts</source>
        <translation>Berührungen werden getrennt</translation>
    </message>
    <message>
        <source>Largest distance between the flat triangles and the curved elements</source>
        <translation>Größter Abstand zwischen den ebenen Dreiecken und den gekrümmten Elementen</translation>
    </message>
    <message>
        <source>no minimum</source>
        <translation>kein Mindestwert</translation>
    </message>
    <message>
        <source>Operands: {}</source>
        <translation>Operanden: {}</translation>
    </message>
    <message>
        <source>Set operation, applied to the operands in their order; difference: the first one without the others</source>
        <translation>Mengenoperation, der Reihe nach auf die Operanden angewandt; Differenz: der erste ohne die übrigen</translation>
    </message>
    <message>
        <source>A local size is given for {name}, but the shape has only {count} of these</source>
        <translation>Für {name} ist eine lokale Größe angegeben, aber die Form hat nur {count} davon</translation>
    </message>
    <message>
        <source>A display accuracy of {length} is below the single precision of meshes in FreeCAD, here {length2}. Choose a larger value</source>
        <translation>Eine Genauigkeit der Anzeige von {length} liegt unter der einfachen Genauigkeit von Netzen in FreeCAD, hier {length2}. Wählen Sie einen größeren Wert</translation>
    </message>
    <message>
        <source>A display accuracy of {length} takes more than {count} triangles. Choose a larger value</source>
        <translation>Eine Genauigkeit der Anzeige von {length} braucht mehr als {count} Dreiecke. Wählen Sie einen größeren Wert</translation>
    </message>
    <message>
        <source>A max. deviation of {length} is below the single precision of meshes in FreeCAD, here {length2}. Choose a larger value</source>
        <translation>Eine max. Abweichung von {length} liegt unter der einfachen Genauigkeit von Netzen in FreeCAD, hier {length2}. Wählen Sie einen größeren Wert</translation>
    </message>
    <message>
        <source>Longest edge on single faces, along edges or around vertices: Face3=0.5 mm, Edge7=0.2 mm; in containers and links with the path to the object: Box.Face3=0.5 mm</source>
        <translation>Längste Kante auf einzelnen Flächen, entlang von Kanten oder um Ecken: Face3=0.5 mm, Edge7=0.2 mm; in Containern und Verknüpfungen mit dem Weg zum Objekt: Box.Face3=0.5 mm</translation>
    </message>
    <message>
        <source>The max. deviation is given twice, as unlimited and as {number} of the size: give one of them</source>
        <translation>Die max. Abweichung ist doppelt angegeben, als unbegrenzt und als {number} der Größe: Geben Sie eine davon an</translation>
    </message>
    <message>
        <source>The max. deviation is given twice, as {length} and as {number} of the size: give one of them</source>
        <translation>Die max. Abweichung ist doppelt angegeben, als {length} und als {number} der Größe: Geben Sie eine davon an</translation>
    </message>
    <message>
        <source>The shortest edge of {length} is longer than the longest edge of {length2}</source>
        <translation>Die kürzeste Kante von {length} ist länger als die längste Kante von {length2}</translation>
    </message>
    <message>
        <source>greater than {length}</source>
        <translation>größer als {length}</translation>
    </message>
    <message>
        <source>greater than {length}, or without a limit</source>
        <translation>größer als {length} oder ohne Grenze</translation>
    </message>
    <message>
        <source>greater than {number} and at most {number2} degrees</source>
        <translation>größer als {number} und höchstens {number2} Grad</translation>
    </message>
    <message>
        <source>lengths greater than 0 by sub-elements, such as Face3=0.5 mm, Edge7=0.2 mm</source>
        <translation>Längen größer als 0 für Unterelemente, etwa Face3=0.5 mm, Edge7=0.2 mm</translation>
    </message>
    <message>
        <source>longest edge {length} (requested {length2}), {phrase}.</source>
        <translation>längste Kante {length} (verlangt {length2}), {phrase}.</translation>
    </message>
    <message>
        <source>max. deviation {length}</source>
        <translation>max. Abweichung {length}</translation>
    </message>
    <message>
        <source>max. deviation {length} (requested {length2}), {phrase}.</source>
        <translation>max. Abweichung {length} (verlangt {length2}), {phrase}.</translation>
    </message>
    <message>
        <source>max. deviation {length} (requested {length2}).</source>
        <translation>max. Abweichung {length} (verlangt {length2}).</translation>
    </message>
    <message>
        <source>the local size of {name} is {length}: single precision holds edges of this shape from {length2} on; choose a larger value</source>
        <translation>Die lokale Größe von {name} ist {length}: Einfache Genauigkeit erlaubt bei dieser Form Kanten ab {length2}; wählen Sie einen größeren Wert</translation>
    </message>
    <message>
        <source>{option} is {length}: single precision holds edges of this shape from {length2} on; choose a larger value</source>
        <translation>{option} ist {length}: Einfache Genauigkeit erlaubt bei dieser Form Kanten ab {length2}; wählen Sie einen größeren Wert</translation>
    </message>
    <message>
        <source>{option}: {length} is not possible, it must be {range}</source>
        <translation>{option}: {length} geht nicht, verlangt ist: {range}</translation>
    </message>
    <message>
        <source>1 pair of triangles where bodies overlap</source>
        <translation>1 Paar von Dreiecken, an dem sich Körper durchdringen</translation>
    </message>
    <message>
        <source>before curving: {phrase}</source>
        <translation>vor dem Krümmen: {phrase}</translation>
    </message>
    <message>
        <source>{count} pairs of triangles where bodies overlap</source>
        <translation>{count} Paare von Dreiecken, an denen sich Körper durchdringen</translation>
    </message>
    <message>
        <source>Set by the expression {}. To edit the value here, clear the expression in the property editor.</source>
        <translation>Durch den Ausdruck {} festgelegt. Um den Wert hier zu ändern, den Ausdruck im Eigenschafteneditor löschen.</translation>
    </message>
    <message>
        <source>it is made of {name} and cannot lie in that, as each would wait for the other: it was taken out again, and follows from outside, too</source>
        <translation>es besteht aus {name} und kann nicht darin liegen, weil jedes auf das andere warten würde: es wurde wieder herausgenommen und folgt auch von außen</translation>
    </message>
    <message>
        <source>it is made of {name} and cannot lie in that, as each would wait for the other: put it beside that, where it follows, too</source>
        <translation>es besteht aus {name} und kann nicht darin liegen, weil jedes auf das andere warten würde: bitte daneben legen, auch dort folgt es</translation>
    </message>
    <message>
        <source>the surface is inside out: its triangles face inwards.</source>
        <translation>die Oberfläche ist umgestülpt: Ihre Dreiecke zeigen nach innen.</translation>
    </message>
    <message>
        <source>{option} cannot be changed: the property {name} of {name2} is set by the expression {value}; clear that first, by {name3} or in the property editor</source>
        <translation>{option} lässt sich nicht ändern: Die Eigenschaft {name} von {name2} wird durch den Ausdruck {value} festgelegt; bitte diesen zuerst löschen, mit {name3} oder im Eigenschafteneditor</translation>
    </message>
    <message>
        <source>what could not be interrupted has ended</source>
        <translation>was sich nicht unterbrechen ließ, ist beendet</translation>
    </message>
    <message>
        <source>waits for “{}”: {}</source>
        <translation>wartet auf „{}“: {}</translation>
    </message>
    <message>
        <source>Counting triangles</source>
        <translation>Dreiecke zählen</translation>
    </message>
    <message>
        <source>waits for FreeCAD: recomputing {}</source>
        <translation>wartet auf FreeCAD: {} wird neu berechnet</translation>
    </message>
    <message>
        <source>waits for FreeCAD: undoing or redoing in {}</source>
        <translation>wartet auf FreeCAD: in {} wird ein Schritt zurückgenommen oder wiederholt</translation>
    </message>
    <message>
        <source>waits for FreeCAD: loading {}</source>
        <translation>wartet auf FreeCAD: {} wird geladen</translation>
    </message>
    <message>
        <source>OpenCASCADE still finishes: {stage}</source>
        <translation>OpenCASCADE arbeitet noch: {stage}</translation>
    </message>
    <message>
        <source>checking {name}</source>
        <translation>{name} wird geprüft</translation>
    </message>
    <message>
        <source>comparing the shape with the last one</source>
        <translation>Form wird mit der letzten verglichen</translation>
    </message>
    <message>
        <source>measuring the size of the shape</source>
        <translation>Größe der Form wird gemessen</translation>
    </message>
    <message>
        <source>measuring the volume of {name}</source>
        <translation>Volumen von {name} wird gemessen</translation>
    </message>
    <message>
        <source>reading {name}</source>
        <translation>{name} wird gelesen</translation>
    </message>
    <message>
        <source>still finishes: {stage}</source>
        <translation>arbeitet noch: {stage}</translation>
    </message>
    <message>
        <source>waits for FreeCAD: adding the mesh to the document</source>
        <translation>wartet auf FreeCAD: Das Netz kommt ins Dokument</translation>
    </message>
    <message>
        <source>waits for OpenCASCADE: {stage}</source>
        <translation>wartet auf OpenCASCADE: {stage}</translation>
    </message>
    <message>
        <source>waits for the shape engine, used by {name}</source>
        <translation>wartet auf den Formkern, belegt durch: {name}</translation>
    </message>
    <message>
        <source>1 hidden object of {name} is no part of it: {list}.</source>
        <translation>1 ausgeblendetes Objekt von {name} gehört nicht dazu: {list}.</translation>
    </message>
    <message>
        <source>{count} hidden objects of {name} are no part of it: {list}.</source>
        <translation>{count} ausgeblendete Objekte von {name} gehören nicht dazu: {list}.</translation>
    </message>
    <message>
        <source>a crease of {name}</source>
        <translation>einem Knick von {name}</translation>
    </message>
    <message>
        <source>the end of a crease on {name}</source>
        <translation>dem Ende eines Knicks auf {name}</translation>
    </message>
    <message>
        <source>other work</source>
        <translation>andere Arbeit</translation>
    </message>
    <message>
        <source>{name} is null: it has no geometry; what is hidden in a container does not count: show it</source>
        <translation>{name} ist leer: ohne Geometrie; was in einem Behälter ausgeblendet ist, zählt nicht: blenden Sie es ein</translation>
    </message>
    <message>
        <source>{solid}: {phrase} ({value})</source>
        <translation>{solid}: {phrase} ({value})</translation>
    </message>
    <message>
        <source>Join faces that belong to no shell, as those of most IGES files, where their borders lie together; the report says how far apart they were</source>
        <translation>Flächen ohne Hülle, wie die der meisten IGES-Dateien, verbinden, wo ihre Ränder aufeinanderliegen; der Bericht sagt, wie weit sie auseinanderlagen</translation>
    </message>
    <message>
        <source>Join loose faces</source>
        <translation>Lose Flächen verbinden</translation>
    </message>
    <message>
        <source>1: straight sides; 2: quadratic elements, which follow curved faces and bend as they should</source>
        <translation>1: gerade Seiten; 2: quadratische Elemente, die gekrümmten Flächen folgen und sich richtig biegen</translation>
    </message>
    <message>
        <source>Fill the solids with tetrahedra; off, and where there is no solid: triangles for shells</source>
        <translation>Füllt die Körper mit Tetraedern; aus, und wo es keinen Körper gibt: Dreiecke für Schalen</translation>
    </message>
    <message>
        <source>the analysis {name} has another mesh, {name2}: FreeCAD solves on one mesh only; take the others out</source>
        <translation>die Analyse {name} hat ein weiteres Netz, {name2}: FreeCAD rechnet nur auf einem Netz; die anderen herausnehmen</translation>
    </message>
    <message>
        <source>inside of the part</source>
        <translation>im Innern des Teils</translation>
    </message>
    <message>
        <source>around the part</source>
        <translation>um das Teil herum</translation>
    </message>
    <message>
        <source>Length of the cells far from the surface; 0: 1/20 of the part inside, 1/4 around it. Cells at the surface are as large as its triangles.</source>
        <translation>Länge der Zellen fern der Oberfläche; 0: 1/20 des Teils im Innern, 1/4 außen. An der Oberfläche sind Zellen so groß wie ihre Dreiecke.</translation>
    </message>
    <message>
        <source>Mesh: {}</source>
        <translation>Netz: {}</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Strömung</translation>
    </message>
    <message>
        <source>Background cells (0: by the size)</source>
        <translation>Hintergrundzellen (0: nach der Größe)</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Choose a folder, or type its name.</source>
        <translation>Wählen Sie einen Ordner oder geben Sie seinen Namen ein.</translation>
    </message>
    <message>
        <source>The unit of the numbers in the file: solvers mostly take metres</source>
        <translation>Die Einheit der Zahlen in der Datei: Löser nehmen meist Meter</translation>
    </message>
    <message>
        <source>As text, one solid a patch</source>
        <translation>Als Text, ein „solid“ je Patch</translation>
    </message>
    <message>
        <source>STL as text, which OpenFOAM takes the names of patches from</source>
        <translation>STL als Text, dem OpenFOAM die Namen der Patches entnimmt</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Patches: {}</source>
        <translation>Patches: {}</translation>
    </message>
    <message>
        <source>Each face is a patch by its own name; the command Patches names them.</source>
        <translation>Jede Fläche ist ein Patch mit ihrem eigenen Namen; der Befehl Patches benennt sie.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>each by its own name</source>
        <translation>je einzeln</translation>
    </message>
    <message>
        <source>Mesh: {}. Select faces in the 3D view, then add them.</source>
        <translation>Netz: {}. Wählen Sie Flächen in der 3D-Ansicht und fügen Sie sie dann hinzu.</translation>
    </message>
    <message>
        <source>New patch</source>
        <translation>Neuer Patch</translation>
    </message>
    <message>
        <source>Make a patch of the faces that are selected in the 3D view</source>
        <translation>Macht aus den in der 3D-Ansicht gewählten Flächen einen Patch</translation>
    </message>
    <message>
        <source>Add faces</source>
        <translation>Flächen dazu</translation>
    </message>
    <message>
        <source>Add the faces that are selected in the 3D view to the patch that is marked in the list</source>
        <translation>Fügt die in der 3D-Ansicht gewählten Flächen dem in der Liste markierten Patch hinzu</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Choose the colour of the marked patch</source>
        <translation>Farbe des markierten Patches wählen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the marked patches from the list</source>
        <translation>Entfernt die markierten Patches aus der Liste</translation>
    </message>
    <message>
        <source>Take patches from ...</source>
        <translation>Patches übernehmen von ...</translation>
    </message>
    <message>
        <source>labels of parts</source>
        <translation>Bezeichnungen der Teile</translation>
    </message>
    <message>
        <source>colours of faces</source>
        <translation>Farben der Flächen</translation>
    </message>
    <message>
        <source>an analysis (FEM, CfdOF)</source>
        <translation>einer Analyse (FEM, CfdOF)</translation>
    </message>
    <message>
        <source>All other faces</source>
        <translation>Alle anderen Flächen</translation>
    </message>
    <message>
        <source>Mark one patch in the list first.</source>
        <translation>Markieren Sie zuerst einen Patch in der Liste.</translation>
    </message>
    <message>
        <source>Select faces of {} in the 3D view first.</source>
        <translation>Wählen Sie zuerst Flächen von {} in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Give solids that share an area the same triangles on both sides, as analyses of assemblies need; the report names the pairs</source>
        <translation>Gibt Körpern, die sich in einer Fläche berühren, auf beiden Seiten dieselben Dreiecke, wie Analysen von Baugruppen sie brauchen; der Bericht nennt die Paare</translation>
    </message>
    <message>
        <source>Cancelled; files of the case that were written already stay.</source>
        <translation>Abgebrochen; schon geschriebene Dateien des Falls bleiben.</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Patches</translation>
    </message>
    <message>
        <source>Join bodies that touch</source>
        <translation>Berührende Körper verbinden</translation>
    </message>
    <message>
        <source>A patch names {value}, but {name} does not hold that: select it again in the 3D view</source>
        <translation>Ein Patch nennt {value}, aber {name} enthält das nicht: Wählen Sie es in der 3D-Ansicht neu</translation>
    </message>
    <message>
        <source>OpenFOAM cannot hold a patch called {name}: give it letters without accents, digits, _ - + and . only, a letter first</source>
        <translation>OpenFOAM kann keinen Patch namens {name} enthalten: Verwenden Sie nur Buchstaben ohne Akzente, Ziffern, _ - + und ., einen Buchstaben zuerst</translation>
    </message>
    <message>
        <source>Patch {name} has the name of a face that is in no patch: give it another name, or name all other faces</source>
        <translation>Patch {name} heißt wie eine Fläche, die in keinem Patch ist: Geben Sie ihm einen anderen Namen oder benennen Sie alle anderen Flächen</translation>
    </message>
    <message>
        <source>The length of the cells is not possible: it must be at least {length} and less than the size of the part, {length2}</source>
        <translation>Die Länge der Zellen ist nicht möglich: Sie muss mindestens {length} und kleiner als die Größe des Teils, {length2}, sein</translation>
    </message>
    <message>
        <source>The mesh has {count} solids, and one space is meshed at a time: unite them first, or take one alone</source>
        <translation>Das Netz hat {count} Körper, und es wird ein Raum auf einmal vernetzt: Vereinigen Sie sie zuerst oder nehmen Sie einen allein</translation>
    </message>
    <message>
        <source>no point inside of the mesh was found: it encloses no space</source>
        <translation>kein Punkt im Innern des Netzes wurde gefunden: Es umschließt keinen Raum</translation>
    </message>
    <message>
        <source>patch {name} has the name of a group of the FEM mesh: give it another name</source>
        <translation>Patch {name} heißt wie eine Gruppe des FEM-Netzes: Geben Sie ihm einen anderen Namen</translation>
    </message>
    <message>
        <source>patch {name} names {face}, but {name2} has faces Face1 to {face2}: take it out or name another one</source>
        <translation>Patch {name} nennt {face}, aber {name2} hat die Flächen Face1 bis {face2}: Nehmen Sie sie heraus oder nennen Sie eine andere</translation>
    </message>
    <message>
        <source>patch {name} names {value}, which is no face: give names such as Face1</source>
        <translation>Patch {name} nennt {value}, was keine Fläche ist: Geben Sie Namen wie Face1 an</translation>
    </message>
    <message>
        <source>the case has no folder: give the name of one</source>
        <translation>der Fall hat keinen Ordner: Geben Sie den Namen eines Ordners an</translation>
    </message>
    <message>
        <source>the file has no name: give one that ends in one of {value}</source>
        <translation>die Datei hat keinen Namen: Geben Sie einen mit einer dieser Endungen an: {value}</translation>
    </message>
    <message>
        <source>the mesh has {count} open edges: meshers of flows need a closed surface; close the part, or mesh all of its faces</source>
        <translation>das Netz hat {count} offene Kanten: Vernetzer für Strömungen brauchen eine geschlossene Oberfläche; schließen Sie das Teil oder vernetzen Sie alle seine Flächen</translation>
    </message>
    <message>
        <source>the patch {value} is not possible: write its name, a colon and its faces, such as &quot;inlet: Face1, Face4&quot;</source>
        <translation>der Patch {value} ist nicht möglich: Schreiben Sie seinen Namen, einen Doppelpunkt und seine Flächen, etwa &quot;inlet: Face1, Face4&quot;</translation>
    </message>
    <message>
        <source>the patches are not followed: {text}</source>
        <translation>die Patches folgen nicht: {text}</translation>
    </message>
    <message>
        <source>there are two patches called {name}: put their faces into one</source>
        <translation>zwei Patches heißen {name}: Fassen Sie ihre Flächen zu einem zusammen</translation>
    </message>
    <message>
        <source>{face} is in patch {name} and in patch {name2}: a face belongs to one patch; name it once</source>
        <translation>{face} steht in Patch {name} und in Patch {name2}: Eine Fläche gehört zu einem Patch; nennen Sie sie einmal</translation>
    </message>
    <message>
        <source>{face} is twice in patch {name}: a face belongs to one patch; name it once</source>
        <translation>{face} steht zweimal in Patch {name}: Eine Fläche gehört zu einem Patch; nennen Sie sie einmal</translation>
    </message>
    <message>
        <source>{face} of patch {name} may be another face after the edit: choose the faces of the patch anew</source>
        <translation>{face} von Patch {name} kann nach der Änderung eine andere Fläche sein: Wählen Sie die Flächen des Patches neu</translation>
    </message>
    <message>
        <source>{name} has faces of one colour alone: colour them in the 3D view, or choose faces</source>
        <translation>{name} hat Flächen von nur einer Farbe: Färben Sie sie in der 3D-Ansicht oder wählen Sie Flächen</translation>
    </message>
    <message>
        <source>{name} has no faces to which an analysis refers: add constraints, or choose faces</source>
        <translation>{name} hat keine Flächen, auf die sich eine Analyse bezieht: Fügen Sie Randbedingungen hinzu oder wählen Sie Flächen</translation>
    </message>
    <message>
        <source>{name} has no triangles: compute it first</source>
        <translation>{name} hat keine Dreiecke: Berechnen Sie es zuerst</translation>
    </message>
    <message>
        <source>{name} holds no parts: choose faces, or name patches by an analysis</source>
        <translation>{name} enthält keine Teile: Wählen Sie Flächen oder benennen Sie Patches nach einer Analyse</translation>
    </message>
    <message>
        <source>{value} cannot be written</source>
        <translation>{value} kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>{value} files cannot hold a patch called {name}: names there have at most {count} characters; give it a shorter one</source>
        <translation>{value}-Dateien können keinen Patch namens {name} enthalten: Namen haben dort höchstens {count} Zeichen; geben Sie ihm einen kürzeren</translation>
    </message>
    <message>
        <source>{value} is a folder and cannot be written: give the name of a file that ends in one of {value2}</source>
        <translation>{value} ist ein Ordner und kann nicht geschrieben werden: Geben Sie den Namen einer Datei mit einer dieser Endungen an: {value2}</translation>
    </message>
    <message>
        <source>{value} is not possible as the name of a patch: give a text that is not empty, without blanks at its ends</source>
        <translation>{value} ist als Name eines Patches nicht möglich: Geben Sie einen Text an, der nicht leer ist und keine Leerzeichen am Anfang oder Ende hat</translation>
    </message>
    <message>
        <source>{value} is not possible as the name of a patch: it ends as a colour does; choose another</source>
        <translation>{value} ist als Name eines Patches nicht möglich: Er endet wie eine Farbe; wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>{value} is not possible as the name of the other faces: give one without blanks at its ends</source>
        <translation>{value} ist als Name der anderen Flächen nicht möglich: Geben Sie einen ohne Leerzeichen am Anfang oder Ende an</translation>
    </message>
    <message>
        <source>{value}: a mesh is written into files with a name that ends in one of {value2}</source>
        <translation>{value}: Ein Netz wird in Dateien mit einer dieser Endungen geschrieben: {value2}</translation>
    </message>
    <message>
        <source>{value}: curved elements of order {count} are written into files with a name that ends in one of {value2}</source>
        <translation>{value}: Gekrümmte Elemente der Ordnung {count} werden in Dateien mit einer dieser Endungen geschrieben: {value2}</translation>
    </message>
    <message>
        <source>{value}: there is no folder {value2}</source>
        <translation>{value}: Es gibt keinen Ordner {value2}</translation>
    </message>
    <message>
        <source>Least / largest Jacobian</source>
        <translation>Jacobi-Determinante min / max</translation>
    </message>
    <message>
        <source>1 = not distorted by its middle nodes, ≤ 0 = not proven valid; those are marked.</source>
        <translation>1 = durch die Mittelknoten nicht verzerrt, ≤ 0 = nicht als gültig bewiesen; diese sind hervorgehoben.</translation>
    </message>
    <message>
        <source>{0} of {1} are not proven valid.</source>
        <translation>{0} von {1} sind nicht als gültig bewiesen.</translation>
    </message>
    <message>
        <source>1 element replaced</source>
        <translation>1 Element ersetzt</translation>
    </message>
    <message>
        <source>1 vertex moved</source>
        <translation>1 Eckpunkt verschoben</translation>
    </message>
    <message>
        <source>Given is empty: the FEM mesh was deleted; choose another one, or delete this mesh</source>
        <translation>Given ist leer: Das FEM-Netz wurde gelöscht; wählen Sie ein anderes, oder löschen Sie dieses Netz</translation>
    </message>
    <message>
        <source>finding curved triangles that cross</source>
        <translation>gekrümmte Dreiecke suchen, die sich durchdringen</translation>
    </message>
    <message>
        <source>checking the elements</source>
        <translation>Elemente werden geprüft</translation>
    </message>
    <message>
        <source>given mesh: 1 of {count2} elements is not proven valid</source>
        <translation>gegebenes Netz: 1 von {count2} Elementen ist nicht als gültig bewiesen</translation>
    </message>
    <message>
        <source>given mesh: {count} of {count2} elements are not proven valid</source>
        <translation>gegebenes Netz: {count} von {count2} Elementen sind nicht als gültig bewiesen</translation>
    </message>
    <message>
        <source>in the analysis {name} it takes the place of {name2}, as FreeCAD solves on one mesh only; what it replaces stays in the document</source>
        <translation>in der Analyse {name} tritt es an die Stelle von {name2}, da FreeCAD nur auf einem Netz rechnet; was es ersetzt, bleibt im Dokument</translation>
    </message>
    <message>
        <source>neighbouring elements disagree on the side that is outside.</source>
        <translation>benachbarte Elemente sind uneins, welche Seite außen ist.</translation>
    </message>
    <message>
        <source>now 1 of {count2}</source>
        <translation>jetzt 1 von {count2}</translation>
    </message>
    <message>
        <source>now {count} of {count2}</source>
        <translation>jetzt {count} von {count2}</translation>
    </message>
    <message>
        <source>the group {name} has lost 1 element, which was replaced: add those that are there now to it</source>
        <translation>die Gruppe {name} hat 1 Element verloren, das ersetzt wurde: Fügen Sie ihr die hinzu, die jetzt dort sind</translation>
    </message>
    <message>
        <source>the group {name} has lost {count} elements, which were replaced: add those that are there now to it</source>
        <translation>die Gruppe {name} hat {count} Elemente verloren, die ersetzt wurden: Fügen Sie ihr die hinzu, die jetzt dort sind</translation>
    </message>
    <message>
        <source>the surface of the mesh is not measured: it is not of triangles of one order</source>
        <translation>die Oberfläche des Netzes ist nicht vermessen: sie besteht nicht aus Dreiecken einer Ordnung</translation>
    </message>
    <message>
        <source>{count} elements replaced</source>
        <translation>{count} Elemente ersetzt</translation>
    </message>
    <message>
        <source>{count} vertices moved</source>
        <translation>{count} Eckpunkte verschoben</translation>
    </message>
    <message>
        <source>{name} does not say of which part it is a mesh: give part=, or select the part beside it</source>
        <translation>{name} sagt nicht, von welchem Teil es ein Netz ist: Geben Sie part= an, oder wählen Sie das Teil dazu aus</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>the elements do not fit together: a face has more than two of them, or a corner of one lies amid an edge or a face of another.</source>
        <translation>die Elemente passen nicht zusammen: eine Fläche hat mehr als zwei davon, oder eine Ecke des einen liegt inmitten einer Kante oder Fläche eines anderen.</translation>
    </message>
    <message>
        <source>the surface is not on the shape: {text}.</source>
        <translation>die Oberfläche liegt nicht auf der Form: {text}.</translation>
    </message>
    <message>
        <source>FEM mesh: {}, with its groups</source>
        <translation>FEM-Netz: {}, mit seinen Gruppen</translation>
    </message>
    <message>
        <source>1 pair of bodies lies in one another.</source>
        <translation>1 Paar von Körpern liegt ineinander.</translation>
    </message>
    <message>
        <source>measuring the distance from the shape to the mesh</source>
        <translation>Abstand der Form vom Netz messen</translation>
    </message>
    <message>
        <source>{count} pairs of bodies lie in one another.</source>
        <translation>{count} Paare von Körpern liegen ineinander.</translation>
    </message>
    <message>
        <source>Corner angle</source>
        <translation>Eckenwinkel</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Inscribed spheres</source>
        <translation>Einbeschriebene Kugeln</translation>
    </message>
    <message>
        <source>Largest distance between neighbouring points that are measured</source>
        <translation>Größter Abstand benachbarter Punkte, an denen gemessen wird</translation>
    </message>
    <message>
        <source>Largest distance of the mesh that is measured from a shape</source>
        <translation>Größter Abstand des gemessenen Netzes von einer Form</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Measure the gaps and slots outside of each solid, in place of its walls</source>
        <translation>Statt der Wände die Spalte und Schlitze außerhalb jedes Körpers messen</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Strahlen</translation>
    </message>
    <message>
        <source>Smallest thickness</source>
        <translation>Kleinste Dicke</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Punktabstand</translation>
    </message>
    <message>
        <source>Surfaces inclined to each other by more than this are a corner, not the sides of a wall</source>
        <translation>Flächen, die stärker gegeneinander geneigt sind, bilden eine Ecke und sind nicht die Seiten einer Wand</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Walls thinner than this are reported</source>
        <translation>Dünnere Wände werden gemeldet</translation>
    </message>
    <message>
        <source>by the thinnest wall</source>
        <translation>nach der dünnsten Wand</translation>
    </message>
    <message>
        <source>measuring the thickness</source>
        <translation>Dicke wird gemessen</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>preparing the solids</source>
        <translation>Körper werden vorbereitet</translation>
    </message>
    <message>
        <source>size / 50</source>
        <translation>Größe / 50</translation>
    </message>
    <message>
        <source>smallest gap {length} (requested {length2}).</source>
        <translation>kleinster Spalt {length} (verlangt {length2}).</translation>
    </message>
    <message>
        <source>smallest thickness {length} (requested {length2}).</source>
        <translation>kleinste Dicke {length} (verlangt {length2}).</translation>
    </message>
    <message>
        <source>spheres: diameter of the largest ball in the solid that touches the surface there; rays: along the inward normal to the other side</source>
        <translation>Kugeln: Durchmesser der größten Kugel im Körper, die die Oberfläche dort berührt; Strahlen: entlang der Normalen nach innen bis zur anderen Seite</translation>
    </message>
    <message>
        <source>1 pair of bodies overlaps.</source>
        <translation>1 Paar von Körpern überlappt sich.</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>Pairs of bodies farther from each other than this are left out</source>
        <translation>Paare von Körpern, die weiter auseinander liegen, werden ausgelassen</translation>
    </message>
    <message>
        <source>Pairs of bodies nearer to each other than this are reported</source>
        <translation>Paare von Körpern, die näher beieinander liegen, werden gemeldet</translation>
    </message>
    <message>
        <source>Smallest clearance</source>
        <translation>Kleinster Abstand</translation>
    </message>
    <message>
        <source>measuring the clearance</source>
        <translation>Abstand wird gemessen</translation>
    </message>
    <message>
        <source>{count} pairs of bodies overlap.</source>
        <translation>{count} Paare von Körpern überlappen sich.</translation>
    </message>
    <message>
        <source>1 closed void.</source>
        <translation>1 geschlossener Hohlraum.</translation>
    </message>
    <message>
        <source>1 face has undercuts.</source>
        <translation>1 Fläche hat Hinterschneidungen.</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entformungsschräge</translation>
    </message>
    <message>
        <source>Draft that walls should have</source>
        <translation>Schräge, die Wände haben sollen</translation>
    </message>
    <message>
        <source>Smallest draft</source>
        <translation>Kleinste Schräge</translation>
    </message>
    <message>
        <source>less draft than {number}° on 1 face.</source>
        <translation>weniger Schräge als {number}° an 1 Fläche.</translation>
    </message>
    <message>
        <source>less draft than {number}° on {count} faces.</source>
        <translation>weniger Schräge als {number}° an {count} Flächen.</translation>
    </message>
    <message>
        <source>measuring the draft</source>
        <translation>Entformungsschräge wird gemessen</translation>
    </message>
    <message>
        <source>{count} closed voids.</source>
        <translation>{count} geschlossene Hohlräume.</translation>
    </message>
    <message>
        <source>{count} faces have undercuts.</source>
        <translation>{count} Flächen haben Hinterschneidungen.</translation>
    </message>
    <message>
        <source>Add the faces that are selected in the 3D view</source>
        <translation>Die in der 3D-Ansicht gewählten Flächen hinzufügen</translation>
    </message>
    <message>
        <source>Faces are chosen of one object: open the panel for that object alone.</source>
        <translation>Flächen werden von einem Objekt gewählt: Das Fenster für dieses Objekt allein öffnen.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Faces of the shape that get no wall, so that the hollow reaches them; none: the hollow is closed</source>
        <translation>Flächen der Form, die keine Wand bekommen, so dass der Hohlraum bis zu ihnen reicht; keine: der Hohlraum ist geschlossen</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Aushöhlen</translation>
    </message>
    <message>
        <source>How far the surface moves: outward, or inward where it is below 0</source>
        <translation>Wie weit sich die Oberfläche verschiebt: nach außen, bei Werten unter 0 nach innen</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Openings</source>
        <translation>Öffnungen</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Thickness of the wall, which grows inward from the surface</source>
        <translation>Dicke der Wand, die von der Oberfläche nach innen wächst</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Threads that work at a time; 0: one for each core</source>
        <translation>Threads, die gleichzeitig arbeiten; 0: einer für jeden Kern</translation>
    </message>
    <message>
        <source>an opening names {value}, but {name} does not hold that: select it again in the 3D view</source>
        <translation>eine Öffnung nennt {value}, aber {name} enthält das nicht: in der 3D-Ansicht neu wählen</translation>
    </message>
    <message>
        <source>an opening names {value}, but {name} has faces Face1 to {face}: take it out or name another one</source>
        <translation>eine Öffnung nennt {value}, aber {name} hat die Flächen Face1 bis {face}: herausnehmen oder eine andere nennen</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>muss angegeben werden</translation>
    </message>
    <message>
        <source>names of faces, such as Face3, Face7</source>
        <translation>Namen von Flächen, etwa Face3, Face7</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>nothing is left: the solid is nowhere that deep</source>
        <translation>nichts bleibt übrig: der Körper ist nirgends so tief</translation>
    </message>
    <message>
        <source>openings are faces of a shape, and {name} has a mesh: hollow it without openings, and cut them by a Boolean</source>
        <translation>Öffnungen sind Flächen einer Form, und {name} hat ein Netz: ohne Öffnungen aushöhlen und sie durch eine boolesche Operation schneiden</translation>
    </message>
    <message>
        <source>the solid stays whole: it is nowhere thicker than two walls</source>
        <translation>der Körper bleibt massiv: er ist nirgends dicker als zwei Wände</translation>
    </message>
    <message>
        <source>{face} of the openings may be another face after the edit: choose the openings anew</source>
        <translation>{face} der Öffnungen kann nach der Änderung eine andere Fläche sein: die Öffnungen neu wählen</translation>
    </message>
    <message>
        <source>{name} holds shapes and meshes: unite them by a Boolean first</source>
        <translation>{name} enthält Formen und Netze: zuerst durch eine boolesche Operation vereinigen</translation>
    </message>
    <message>
        <source>{option}: give a length that is not 0</source>
        <translation>{option}: eine Länge angeben, die nicht 0 ist</translation>
    </message>
    <message>
        <source>Largest distance between the result and the exact one, in both directions; unless given, a thousandth of the size, at most a tenth of the distance</source>
        <translation>Größter Abstand zwischen dem Ergebnis und dem exakten, in beiden Richtungen; ohne Angabe ein Tausendstel der Größe, höchstens ein Zehntel des Abstands</translation>
    </message>
    <message>
        <source>by size</source>
        <translation>nach Größe</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>eine Länge</translation>
    </message>
    <message>
        <source>measuring distances</source>
        <translation>Messen der Abstände</translation>
    </message>
    <message>
        <source>offsetting the surface</source>
        <translation>Versetzen der Oberfläche</translation>
    </message>
    <message>
        <source>rounding to single precision</source>
        <translation>Runden auf einfache Genauigkeit</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wanddicke</translation>
    </message>
    <message>
        <source>Diameter of the largest ball in the solid that touches the surface there; ∞ = no wall.</source>
        <translation>Durchmesser der größten Kugel im Körper, die dort die Oberfläche berührt; ∞ = keine Wand.</translation>
    </message>
    <message>
        <source>the mesh has {count} open edges: only solids have walls; close it first</source>
        <translation>das Netz hat {count} offene Kanten: nur Körper haben Wände; erst schließen</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>Largest distance between the wrap and the surfaces that it lies on, at most half of the gap; unless given, a quarter of the gap, at most a fiftieth of the size</source>
        <translation>Größter Abstand zwischen der Hülle und den Flächen, auf denen sie liegt, höchstens die halbe Lücke; ohne Angabe ein Viertel der Lücke, höchstens ein Fünfzigstel der Größe</translation>
    </message>
    <message>
        <source>Width of a ball that rolls over the objects from outside: openings narrower than this are closed</source>
        <translation>Durchmesser einer Kugel, die von außen über die Objekte rollt: engere Öffnungen werden geschlossen</translation>
    </message>
    <message>
        <source>Wrap</source>
        <translation>Umhüllen</translation>
    </message>
    <message>
        <source>by size and gap</source>
        <translation>nach Größe</translation>
    </message>
    <message>
        <source>finding what is near the surface</source>
        <translation>Finden, was nahe an der Oberfläche ist</translation>
    </message>
    <message>
        <source>rolling a ball over the surface</source>
        <translation>Rollen einer Kugel über die Oberfläche</translation>
    </message>
    <message>
        <source>-x</source>
        <translation>-x</translation>
    </message>
    <message>
        <source>-y</source>
        <translation>-y</translation>
    </message>
    <message>
        <source>-z</source>
        <translation>-z</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Closed voids</source>
        <translation>Geschlossene Hohlräume</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Prüfung von Körpern</translation>
    </message>
    <message>
        <source>One half of the mould opens along it, the other one against it</source>
        <translation>In diese Richtung öffnet sich eine Hälfte des Werkzeugs, die andere ihr entgegen</translation>
    </message>
    <message>
        <source>Pull direction</source>
        <translation>Öffnungsrichtung</translation>
    </message>
    <message>
        <source>What is measured: the thickness of walls, the distances between the solids of a shape, the draft against the pull direction of a mould, or cavities from which nothing comes out</source>
        <translation>Was gemessen wird: die Dicke der Wände, die Abstände zwischen den Körpern einer Form, die Entformungsschräge gegen die Öffnungsrichtung eines Werkzeugs, oder Hohlräume, aus denen nichts herauskommt</translation>
    </message>
    <message>
        <source>no two sides face each other: there is no smallest thickness or gap</source>
        <translation>keine zwei Seiten stehen einander gegenüber: es gibt keine kleinste Dicke und keinen kleinsten Spalt</translation>
    </message>
    <message>
        <source>smallest gap {length}</source>
        <translation>kleinster Spalt {length}</translation>
    </message>
    <message>
        <source>smallest thickness {length}</source>
        <translation>kleinste Dicke {length}</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Draft, undercuts</source>
        <translation>Schräge, Hinterschnitt</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>simplifying the surface</source>
        <translation>Vereinfachen der Oberfläche</translation>
    </message>
    <message>
        <source>Sources is empty: choose objects with a mesh or a shape</source>
        <translation>Es sind keine Quellen angegeben: Objekte mit einem Netz oder einer Form wählen</translation>
    </message>
    <message>
        <source>Algorithm: exact divides triangles along the exact intersection; uniform samples along rays (Wang 2010), also operands that are open; default takes uniform where there is no exact result</source>
        <translation>Verfahren: Entweder werden Dreiecke längs der genauen Schnittlinie geteilt, oder die Körper, auch offene, werden längs Strahlen abgetastet (Wang 2010); voreingestellt ist das Abtasten nur, wo es kein genaues Ergebnis gibt</translation>
    </message>
    <message>
        <source>exact where possible</source>
        <translation>genau, wo möglich</translation>
    </message>
    <message>
        <source>looking for the inside of open operands</source>
        <translation>das Innere offener Operanden wird gesucht</translation>
    </message>
    <message>
        <source>method &apos;uniform&apos; would take about {number} GB at the resolution {count}: it can take {number2} GB; choose a resolution of at most {count2}, a tolerance of at least {length}, or method &apos;exact&apos;</source>
        <translation>Das Verfahren „uniform“ bräuchte bei der Auflösung {count} etwa {number} GB: Es darf {number2} GB nehmen; wählen Sie eine Auflösung von höchstens {count2}, eine max. Abweichung von mindestens {length} oder das Verfahren „exact“</translation>
    </message>
    <message>
        <source>{number} % of the surface is a guess, where operands are open.</source>
        <translation>{number} % der Oberfläche sind geschätzt, wo Operanden offen sind.</translation>
    </message>
    <message>
        <source>checking for intersections</source>
        <translation>auf Überschneidungen prüfen</translation>
    </message>
    <message>
        <source>dividing space into cells</source>
        <translation>den Raum in Zellen teilen</translation>
    </message>
    <message>
        <source>proving the distance</source>
        <translation>den Abstand beweisen</translation>
    </message>
    <message>
        <source>Make the whole surface anew from the samples, so that no triangle of the operands stays; only with method uniform</source>
        <translation>Bildet die ganze Oberfläche neu aus den Abtastpunkten, so dass kein Dreieck der Körper bleibt; nur beim Abtasten</translation>
    </message>
    <message>
        <source>Only sampling can reconstruct everything. Choose sampling as the method, or turn &quot;Reconstruct everything&quot; off</source>
        <translation>Nur beim Abtasten kann alles neu gebildet werden. Wählen Sie Abtasten als Verfahren, oder schalten Sie „Alles neu bilden“ aus</translation>
    </message>
    <message>
        <source>Reconstruct everything</source>
        <translation>Alles neu bilden</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>How curves and surfaces are evaluated: fast by formulas and polynomial pieces, native by OpenCASCADE alone, which takes longer</source>
        <translation>Wie Kurven und Flächen ausgewertet werden: schnell durch Formeln und Polynomstücke, oder nur durch OpenCASCADE, was länger dauert</translation>
    </message>
    <message>
        <source>by OpenCASCADE alone</source>
        <translation>nur durch OpenCASCADE</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>refining the bodies</source>
        <translation>Körper verfeinern</translation>
    </message>
    <message>
        <source>1 pair of bodies crosses in the mesh only.</source>
        <translation>1 Paar von Körpern schneidet sich nur im Netz.</translation>
    </message>
    <message>
        <source>1 pair of elements not proven apart</source>
        <translation>1 Paar von Elementen nicht als getrennt bewiesen</translation>
    </message>
    <message>
        <source>Bodies that overlap</source>
        <translation>Körper, die sich überlappen</translation>
    </message>
    <message>
        <source>Whether bodies of a shape that overlap, lie in one another or cross are a fault of the mesh, or allowed; the report names them</source>
        <translation>Ob Körper einer Form, die sich überlappen, ineinander liegen oder sich schneiden, ein Fehler des Netzes sind oder erlaubt; der Bericht nennt sie</translation>
    </message>
    <message>
        <source>are allowed</source>
        <translation>sind erlaubt</translation>
    </message>
    <message>
        <source>are not met</source>
        <translation>sind ein Fehler</translation>
    </message>
    <message>
        <source>{count} pairs of bodies cross in the mesh only.</source>
        <translation>{count} Paare von Körpern schneiden sich nur im Netz.</translation>
    </message>
    <message>
        <source>{count} pairs of elements not proven apart</source>
        <translation>{count} Paare von Elementen nicht als getrennt bewiesen</translation>
    </message>
    <message>
        <source>{name} and {name2} are one body twice.</source>
        <translation>{name} und {name2} sind zweimal derselbe Körper.</translation>
    </message>
    <message>
        <source>{name} and {name2} cross: a smaller max. deviation separates them.</source>
        <translation>{name} und {name2} schneiden sich: eine kleinere max. Abweichung trennt sie.</translation>
    </message>
    <message>
        <source>{name} and {name2} overlap or cross: unite them first, or mesh them with overlap = allow</source>
        <translation>{name} und {name2} überlappen oder schneiden sich: vereinigen Sie sie zuerst, oder vernetzen Sie sie mit overlap = allow</translation>
    </message>
    <message>
        <source>{name} and {name2} overlap.</source>
        <translation>{name} und {name2} überlappen sich.</translation>
    </message>
    <message>
        <source>{name} lies inside {name2}.</source>
        <translation>{name} liegt in {name2}.</translation>
    </message>
    <message>
        <source>finding common faces</source>
        <translation>gemeinsame Flächen suchen</translation>
    </message>
    <message>
        <source>{name} and {name2} count as one, as the shape's tolerances do not tell them apart ({length}): that makes a corner of {number}° between {edge} and {edge2} at {vertex}</source>
        <translation>{name} und {name2} gelten als eins, da die Toleranzen der Form sie nicht unterscheiden ({length}): dadurch entsteht bei {vertex} eine Ecke von {number}° zwischen {edge} und {edge2}</translation>
    </message>
    <message>
        <source>{name} and {name2} count as one, as they are no farther apart than {length}: that makes a corner of {number}°, which the shape does not have and a smaller max. deviation avoids, between {edge} and {edge2} at {vertex}</source>
        <translation>{name} und {name2} gelten als eins, da sie höchstens {length} voneinander entfernt sind: dadurch entsteht bei {vertex} zwischen {edge} und {edge2} eine Ecke von {number}°, die die Form nicht hat und eine kleinere max. Abweichung vermeidet</translation>
    </message>
    <message>
        <source>Keeps within {} of the exact result.</source>
        <translation>Bleibt innerhalb von {} um das genaue Ergebnis.</translation>
    </message>
    <message>
        <source>Counting elements ...</source>
        <translation>Elemente werden gezählt ...</translation>
    </message>
    <message>
        <source>{} elements, with edges up to {}</source>
        <translation>{} Elemente, mit Kanten bis {}</translation>
    </message>
    <message>
        <source>About {} elements, with edges up to {}</source>
        <translation>Etwa {} Elemente, mit Kanten bis {}</translation>
    </message>
    <message>
        <source>Elements through walls</source>
        <translation>Elemente durch Wände</translation>
    </message>
    <message>
        <source>Where no longest edge is given: elements through a wall of mean thickness, which is twice the volume over the area of the surface; at most about 100,000 elements in all</source>
        <translation>Wo keine längste Kante angegeben ist: Elemente durch eine Wand mittlerer Dicke, die das Doppelte des Volumens durch die Fläche der Oberfläche ist; im Ganzen höchstens etwa 100.000 Elemente</translation>
    </message>
    <message>
        <source>by the walls</source>
        <translation>nach den Wänden</translation>
    </message>
    <message>
        <source>Show next</source>
        <translation>Nächste Stelle zeigen</translation>
    </message>
    <message>
        <source>Moves the camera to the next fault of the kind that is marked</source>
        <translation>Bewegt die Kamera zum nächsten Fehler der markierten Art</translation>
    </message>
    <message>
        <source>Searching for faults ...</source>
        <translation>Suche nach Fehlern ...</translation>
    </message>
    <message>
        <source>Searching for faults</source>
        <translation>Suche nach Fehlern</translation>
    </message>
    <message>
        <source>Faults; click to show where:</source>
        <translation>Fehler; ein Klick zeigt, wo:</translation>
    </message>
    <message>
        <source>The mesh has no faults.</source>
        <translation>Das Netz hat keine Fehler.</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>1 duplicate triangle</source>
        <translation>1 doppeltes Dreieck</translation>
    </message>
    <message>
        <source>1 edge between triangles of opposite orientation</source>
        <translation>1 Kante zwischen entgegengesetzt orientierten Dreiecken</translation>
    </message>
    <message>
        <source>1 edge with three or more triangles</source>
        <translation>1 Kante mit drei oder mehr Dreiecken</translation>
    </message>
    <message>
        <source>1 open edge</source>
        <translation>1 offene Kante</translation>
    </message>
    <message>
        <source>1 pair of triangles that cross</source>
        <translation>1 Paar von Dreiecken, die sich durchdringen</translation>
    </message>
    <message>
        <source>1 pair of triangles that touch or fold onto each other</source>
        <translation>1 Paar von Dreiecken, die sich berühren oder aufeinander gefaltet sind</translation>
    </message>
    <message>
        <source>1 triangle without area</source>
        <translation>1 Dreieck ohne Fläche</translation>
    </message>
    <message>
        <source>1 vertex at which the surface only touches itself</source>
        <translation>1 Ecke, an der die Oberfläche sich nur berührt</translation>
    </message>
    <message>
        <source>Largest distance between the repaired surface and the given one, but for holes that are closed</source>
        <translation>Größter Abstand zwischen der reparierten Oberfläche und der gegebenen, außer an Löchern, die geschlossen werden</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparatur</translation>
    </message>
    <message>
        <source>at least {phrase}</source>
        <translation>mindestens {phrase}</translation>
    </message>
    <message>
        <source>repairs: {list}</source>
        <translation>Reparaturen: {list}</translation>
    </message>
    <message>
        <source>size / 300</source>
        <translation>Größe / 300</translation>
    </message>
    <message>
        <source>the mesh has {list}; the command Repair mesh mends faults</source>
        <translation>das Netz hat {list}; der Befehl Netz reparieren behebt Fehler</translation>
    </message>
    <message>
        <source>walls cannot be measured where the mesh has {list}: repair it by the command Repair mesh first</source>
        <translation>Wände sind nicht messbar, wo das Netz Fehler hat ({list}): reparieren Sie es zuerst mit dem Befehl Netz reparieren</translation>
    </message>
    <message>
        <source>{count} duplicate triangles</source>
        <translation>{count} doppelte Dreiecke</translation>
    </message>
    <message>
        <source>{count} edges between triangles of opposite orientation</source>
        <translation>{count} Kanten zwischen entgegengesetzt orientierten Dreiecken</translation>
    </message>
    <message>
        <source>{count} edges with three or more triangles</source>
        <translation>{count} Kanten mit drei oder mehr Dreiecken</translation>
    </message>
    <message>
        <source>{count} open edges</source>
        <translation>{count} offene Kanten</translation>
    </message>
    <message>
        <source>{count} pairs of triangles that cross</source>
        <translation>{count} Paare von Dreiecken, die sich durchdringen</translation>
    </message>
    <message>
        <source>{count} pairs of triangles that touch or fold onto each other</source>
        <translation>{count} Paare von Dreiecken, die sich berühren oder aufeinander gefaltet sind</translation>
    </message>
    <message>
        <source>{count} triangles without area</source>
        <translation>{count} Dreiecke ohne Fläche</translation>
    </message>
    <message>
        <source>{count} vertices at which the surface only touches itself</source>
        <translation>{count} Ecken, an denen die Oberfläche sich nur berührt</translation>
    </message>
    <message>
        <source>touching</source>
        <translation>berühren sich</translation>
    </message>
    <message>
        <source>overlapping</source>
        <translation>überschneiden sich</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>ineinander</translation>
    </message>
    <message>
        <source>equal</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>Click to show where the two bodies are nearest</source>
        <translation>Klicken, um zu zeigen, wo die beiden Körper sich am nächsten sind</translation>
    </message>
    <message>
        <source>{0} ({1} faces)</source>
        <translation>{0} ({1} Flächen)</translation>
    </message>
    <message>
        <source>{0}: patches {1}</source>
        <translation>{0}: Patches {1}</translation>
    </message>
    <message>
        <source>{0}: no patches</source>
        <translation>{0}: keine Patches</translation>
    </message>
    <message>
        <source>all other faces: {0}</source>
        <translation>alle anderen Flächen: {0}</translation>
    </message>
    <message>
        <source>∞, grey: {0} of them</source>
        <translation>∞, grau: {0} davon</translation>
    </message>
    <message>
        <source>{0} (1 face)</source>
        <translation>{0} (1 Fläche)</translation>
    </message>
    <message>
        <source>Mesh Quality: first steps</source>
        <translation>Netzqualität: erste Schritte</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>A max. deviation of {length} is not possible with sampling, which reaches {length2} at best. Choose a larger one or exact intersection as the method</source>
        <translation>Eine max. Abweichung von {length} ist mit Abtasten nicht möglich, das bestenfalls {length2} erreicht. Wählen Sie eine größere oder das Verfahren „genauer Schnitt“</translation>
    </message>
    <message>
        <source>A wrap with a max. deviation of {length} would take more than 2 GB of memory. Choose a larger one</source>
        <translation>Eine Hülle mit einer max. Abweichung von {length} würde mehr als 2 GB Speicher brauchen. Wählen Sie eine größere</translation>
    </message>
    <message>
        <source>Cells along the longest side, or along 8 thicknesses of slender operands; sets the max. deviation if none is given</source>
        <translation>Zellen entlang der längsten Seite, bei schlanken Operanden entlang ihrer achtfachen Dicke; bestimmt die max. Abweichung, wenn keine angegeben ist</translation>
    </message>
    <message>
        <source>Max. deviation from the shape, as a fraction of its largest dimension</source>
        <translation>Max. Abweichung von der Form, als Anteil an ihrer größten Abmessung</translation>
    </message>
    <message>
        <source>Max. deviation: largest distance between the mesh and the shape, as a length</source>
        <translation>Max. Abweichung: größter Abstand zwischen Netz und Form, als Länge</translation>
    </message>
    <message>
        <source>Max. deviation: largest distance between the mesh before it is curved and the shape, as a length</source>
        <translation>Max. Abweichung: größter Abstand zwischen dem Netz vor dem Krümmen und der Form, als Länge</translation>
    </message>
    <message>
        <source>The largest side is more than {count} times the max. deviation of {length}. Choose a larger one</source>
        <translation>Die längste Seite ist mehr als das {count}-Fache der max. Abweichung von {length}. Wählen Sie eine größere</translation>
    </message>
    <message>
        <source>The max. deviation is {length}: at most half of the gap of {length2} is possible; give a smaller one, or a larger gap</source>
        <translation>Die max. Abweichung ist {length}: möglich ist höchstens die Hälfte der Lücke von {length2}; geben Sie eine kleinere oder eine größere Lücke an</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>Kleinster Flächenwinkel</translation>
    </message>
    <message>
        <source>Between two faces of an element: a regular tetrahedron has 70.5°; 10° and less harm simulations.</source>
        <translation>Zwischen zwei Seitenflächen: Ein regelmäßiges Tetraeder hat 70,5°; 10° und weniger schaden Simulationen.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Of the element with straight sides; ≤ 0 = inside out.</source>
        <translation>Bei geraden Seiten; ≤ 0 = umgestülpt.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Flächeninhalt</translation>
    </message>
    <message>
        <source>Of the element with straight sides.</source>
        <translation>Bei geraden Seiten.</translation>
    </message>
    <message>
        <source>All {0} proven valid.</source>
        <translation>Alle {0} nachweislich gültig.</translation>
    </message>
    <message>
        <source>1 of {1} is not proven valid.</source>
        <translation>1 von {1} ist nicht nachweislich gültig.</translation>
    </message>
    <message>
        <source>Written: {0}. In a terminal with OpenFOAM type: {1}</source>
        <translation>Geschrieben: {0}. In einem Terminal mit OpenFOAM eingeben: {1}</translation>
    </message>
    <message>
        <source>OpenFOAM takes no blanks in paths: move the folder to where there are none.</source>
        <translation>OpenFOAM nimmt keine Leerzeichen in Pfaden: Verschieben Sie den Ordner an einen Ort ohne Leerzeichen.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>1 is ideal: all edges of an element have the same length.</source>
        <translation>1 ist ideal: Alle Kanten sind gleich lang.</translation>
    </message>
    <message>
        <source>a closed void is sealed inside, from which resin, powder or air cannot leave; it saves {volume}, {number} % of the volume</source>
        <translation>im Innern ist ein Hohlraum eingeschlossen, aus dem Harz, Pulver oder Luft nicht entweichen können; er spart {volume}, {number} % des Volumens</translation>
    </message>
    <message>
        <source>to make one mesh of bodies that overlap or touch: Join bodies that touch (More options), Mesh Boolean or Wrap</source>
        <translation>um aus Körpern, die einander durchdringen oder berühren, ein Netz zu machen: „Berührende Körper verbinden“ (Weitere Optionen), Boolesche Netzoperation oder Umhüllen</translation>
    </message>
    <message>
        <source>Swap A and B</source>
        <translation>A und B tauschen</translation>
    </message>
    <message>
        <source>A difference is the first operand without the second one</source>
        <translation>Eine Differenz ist der erste Operand ohne den zweiten</translation>
    </message>
    <message>
        <source>Target not decided: {}</source>
        <translation>Ziel nicht entschieden: {}</translation>
    </message>
    <message>
        <source>smallest gap between {length2} and {length3} (requested {length}), as the measured mesh deviates by up to {length4}; a max. deviation of {length5} may decide it, unless the gap is just as wide.</source>
        <translation>kleinster Spalt zwischen {length2} und {length3} (verlangt {length}), da das gemessene Netz um bis zu {length4} abweicht; eine max. Abweichung von {length5} kann es entscheiden, außer der Spalt ist genau so weit.</translation>
    </message>
    <message>
        <source>smallest thickness between {length2} and {length3} (requested {length}), as the measured mesh deviates by up to {length4}; a max. deviation of {length5} may decide it, unless the wall is just as thick.</source>
        <translation>kleinste Dicke zwischen {length2} und {length3} (verlangt {length}), da das gemessene Netz um bis zu {length4} abweicht; eine max. Abweichung von {length5} kann es entscheiden, außer die Wand ist genau so dick.</translation>
    </message>
    <message>
        <source>target not decided: {text}</source>
        <translation>Ziel nicht entschieden: {text}</translation>
    </message>
    <message>
        <source>A clipping plane shows the surface only; click one of the worst to look inside.</source>
        <translation>Eine Schnittebene zeigt nur die Oberfläche; ein Klick auf eines der schlechtesten zeigt das Innere.</translation>
    </message>
    <message>
        <source>1 degenerate triangle removed</source>
        <translation>1 entartetes Dreieck entfernt</translation>
    </message>
    <message>
        <source>1 duplicate triangle removed</source>
        <translation>1 doppeltes Dreieck entfernt</translation>
    </message>
    <message>
        <source>1 edge of more than two triangles parted</source>
        <translation>1 Kante mit mehr als zwei Dreiecken getrennt</translation>
    </message>
    <message>
        <source>1 hole closed (1 triangle)</source>
        <translation>1 Loch geschlossen (1 Dreieck)</translation>
    </message>
    <message>
        <source>1 hole closed ({count2} triangles)</source>
        <translation>1 Loch geschlossen ({count2} Dreiecke)</translation>
    </message>
    <message>
        <source>1 triangle of open sheets removed</source>
        <translation>1 Dreieck offener Blätter entfernt</translation>
    </message>
    <message>
        <source>1 triangle turned around</source>
        <translation>1 Dreieck umgedreht</translation>
    </message>
    <message>
        <source>1 vertex joined across cracks</source>
        <translation>1 Knoten über Risse verbunden</translation>
    </message>
    <message>
        <source>1 vertex of several sheets parted</source>
        <translation>1 Knoten mehrerer Blätter getrennt</translation>
    </message>
    <message>
        <source>1 vertex welded</source>
        <translation>1 Knoten verschmolzen</translation>
    </message>
    <message>
        <source>{count} degenerate triangles removed</source>
        <translation>{count} entartete Dreiecke entfernt</translation>
    </message>
    <message>
        <source>{count} duplicate triangles removed</source>
        <translation>{count} doppelte Dreiecke entfernt</translation>
    </message>
    <message>
        <source>{count} edges of more than two triangles parted</source>
        <translation>{count} Kanten mit mehr als zwei Dreiecken getrennt</translation>
    </message>
    <message>
        <source>{count} holes closed ({count2} triangles)</source>
        <translation>{count} Löcher geschlossen ({count2} Dreiecke)</translation>
    </message>
    <message>
        <source>{count} triangles of open sheets removed</source>
        <translation>{count} Dreiecke offener Blätter entfernt</translation>
    </message>
    <message>
        <source>{count} triangles turned around</source>
        <translation>{count} Dreiecke umgedreht</translation>
    </message>
    <message>
        <source>{count} vertices joined across cracks</source>
        <translation>{count} Knoten über Risse verbunden</translation>
    </message>
    <message>
        <source>{count} vertices of several sheets parted</source>
        <translation>{count} Knoten mehrerer Blätter getrennt</translation>
    </message>
    <message>
        <source>{count} vertices welded</source>
        <translation>{count} Knoten verschmolzen</translation>
    </message>
    <message>
        <source>{name} CFD surface</source>
        <translation>{name} CFD-Oberfläche</translation>
    </message>
    <message>
        <source>{name} FEM mesh</source>
        <translation>{name} FEM-Netz</translation>
    </message>
    <message>
        <source>{name} cured mesh</source>
        <translation>{name} geheiltes Netz</translation>
    </message>
    <message>
        <source>{name} curved mesh</source>
        <translation>{name} gekrümmtes Netz</translation>
    </message>
    <message>
        <source>{name} difference</source>
        <translation>{name} Differenz</translation>
    </message>
    <message>
        <source>{name} hollow</source>
        <translation>{name} ausgehöhlt</translation>
    </message>
    <message>
        <source>{name} improved</source>
        <translation>{name} verbessert</translation>
    </message>
    <message>
        <source>{name} inspection</source>
        <translation>{name} Prüfung</translation>
    </message>
    <message>
        <source>{name} intersection</source>
        <translation>{name} Schnitt</translation>
    </message>
    <message>
        <source>{name} offset</source>
        <translation>{name} Versatz</translation>
    </message>
    <message>
        <source>{name} quality mesh</source>
        <translation>{name} Qualitätsnetz</translation>
    </message>
    <message>
        <source>{name} repaired</source>
        <translation>{name} repariert</translation>
    </message>
    <message>
        <source>{name} symmetric difference</source>
        <translation>{name} symmetrische Differenz</translation>
    </message>
    <message>
        <source>{name} union</source>
        <translation>{name} Vereinigung</translation>
    </message>
    <message>
        <source>{name} wrap</source>
        <translation>{name} Hülle</translation>
    </message>
    <message>
        <source>The max. deviation is {length}: at most the distance of {length2} is possible; give a smaller one</source>
        <translation>Die max. Abweichung ist {length}: möglich ist höchstens der Abstand von {length2}; geben Sie eine kleinere an</translation>
    </message>
    <message>
        <source>the mesh stands beside its part, as FreeCAD&apos;s FEM workbench looks for faces without the containers around them ({name}): it solves rightly; to see mesh and results on the part, take the part out of these</source>
        <translation>das Netz steht neben seinem Bauteil, da FreeCADs FEM-Arbeitsbereich Flächen ohne die Behälter um sie sucht ({name}): gerechnet wird richtig; um Netz und Ergebnisse auf dem Bauteil zu sehen, nehmen Sie das Bauteil aus diesen heraus</translation>
    </message>
    <message>
        <source>the mesh stands beside its part, which lies in {name}, as FreeCAD&apos;s FEM workbench looks for faces without the containers around them: it solves rightly; to see mesh and results on the part, put the analysis, or the mesh without one, into {name}</source>
        <translation>das Netz steht neben seinem Bauteil, das in {name} liegt, da FreeCADs FEM-Arbeitsbereich Flächen ohne die Behälter um sie sucht: gerechnet wird richtig; um Netz und Ergebnisse auf dem Bauteil zu sehen, ziehen Sie die Analyse, oder das Netz ohne eine, in {name}</translation>
    </message>
    <message>
        <source>Colours over the usual range of this measure</source>
        <translation>Farben über den üblichen Bereich dieses Maßes</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Colours begin at this value</source>
        <translation>Die Farben beginnen bei diesem Wert</translation>
    </message>
    <message>
        <source>Colours end at this value</source>
        <translation>Die Farben enden bei diesem Wert</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot compute with the shape: {text}. Repair it with Part &gt; Check geometry</source>
        <translation>OpenCASCADE kann mit der Form nicht rechnen: {text}. Mit Part &gt; Geometrie prüfen reparieren</translation>
    </message>
    <message>
        <source>Python is ending: no work can begin any more</source>
        <translation>Python wird beendet: keine Arbeit kann mehr beginnen</translation>
    </message>
    <message>
        <source>The part has coordinates that are not finite or above {length}; scale it down.</source>
        <translation>Das Teil hat Koordinaten, die nicht endlich sind oder über {length} liegen; verkleinern.</translation>
    </message>
    <message>
        <source>The shape is a {value} without faces. Select a part that has at least one face.</source>
        <translation>Die Form ist ein {value} ohne Flächen. Ein Teil mit mindestens einer Fläche wählen.</translation>
    </message>
    <message>
        <source>The shape is null. Recompute the object, or select one that has a shape.</source>
        <translation>Die Form ist leer. Das Objekt neu berechnen oder eines mit einer Form wählen.</translation>
    </message>
    <message>
        <source>a Boolean of {count} meshes by an expression of {count2} operands</source>
        <translation>Eine boolesche Operation mit {count} Netzen nach einem Ausdruck mit {count2} Operanden</translation>
    </message>
    <message>
        <source>a Boolean without operands: give at least one mesh</source>
        <translation>Eine boolesche Operation ohne Operanden: mindestens ein Netz angeben</translation>
    </message>
    <message>
        <source>a fraction of the longest side, from 0 to less than 0.01</source>
        <translation>ein Bruchteil der längsten Seite, von 0 bis unter 0.01</translation>
    </message>
    <message>
        <source>a hole has at least three vertices, this one {count}</source>
        <translation>Ein Loch hat mindestens drei Eckpunkte, dieses {count}</translation>
    </message>
    <message>
        <source>a point lies outside of the frame of its triangulation</source>
        <translation>Ein Punkt liegt außerhalb des Rahmens seiner Triangulierung</translation>
    </message>
    <message>
        <source>a point on the surface cannot be moved inwards</source>
        <translation>ein Punkt auf der Oberfläche lässt sich nicht nach innen bewegen</translation>
    </message>
    <message>
        <source>a point on the surface finds no place</source>
        <translation>ein Punkt auf der Oberfläche findet keinen Platz</translation>
    </message>
    <message>
        <source>a quadrilateral of the given mesh at {point} lies on {name} and {name2}: mesh the part so that its edges are followed</source>
        <translation>Ein Viereck des gegebenen Netzes bei {point} liegt auf {name} und {name2}: das Teil so vernetzen, dass seinen Kanten gefolgt wird</translation>
    </message>
    <message>
        <source>a triangle is in patch {count}, but there are {count2}, numbered from 0</source>
        <translation>Ein Dreieck ist in Patch {count}, es gibt aber {count2}, gezählt ab 0</translation>
    </message>
    <message>
        <source>a triangle of the surface holds one of its vertices</source>
        <translation>ein Dreieck der Oberfläche enthält einen ihrer Eckpunkte</translation>
    </message>
    <message>
        <source>a vertex of the surface lies on one of its edges</source>
        <translation>ein Eckpunkt der Oberfläche liegt auf einer ihrer Kanten</translation>
    </message>
    <message>
        <source>a {kind} of order {count} has {count2} nodes, not {count3}</source>
        <translation>Ein Element ({kind}) der Ordnung {count} hat {count2} Knoten, nicht {count3}</translation>
    </message>
    <message>
        <source>a {kind} of order {count} has {count2} nodes, or {count4} at its corners and edges only, not {count3}</source>
        <translation>Ein Element ({kind}) der Ordnung {count} hat {count2} Knoten, oder {count4} nur an Ecken und Kanten, nicht {count3}</translation>
    </message>
    <message>
        <source>a {kind} of order {count} is not divided: give solid elements of orders 1 to {count2}</source>
        <translation>Ein Element ({kind}) der Ordnung {count} wird nicht geteilt: Volumenelemente der Ordnungen 1 bis {count2} angeben</translation>
    </message>
    <message>
        <source>all faces are left out: at least one is needed</source>
        <translation>Alle Flächen sind ausgelassen: mindestens eine wird gebraucht</translation>
    </message>
    <message>
        <source>an edge of the surface crosses one of its triangles</source>
        <translation>eine Kante der Oberfläche schneidet eines ihrer Dreiecke</translation>
    </message>
    <message>
        <source>an edge of the surface leads nowhere</source>
        <translation>eine Kante der Oberfläche führt nirgendwohin</translation>
    </message>
    <message>
        <source>an edge where shells of the surface meet cannot be recovered</source>
        <translation>eine Kante, an der Hüllen der Oberfläche sich treffen, lässt sich nicht wiederherstellen</translation>
    </message>
    <message>
        <source>an offset has one operand, and {count} are given: unite them by boolean first</source>
        <translation>Ein Versatz hat einen Operanden, gegeben sind {count}: zuerst durch eine boolesche Operation vereinigen</translation>
    </message>
    <message>
        <source>at least {count} pairs of triangles of the raw offset cross, too many to divide them: choose another distance, or a larger tolerance</source>
        <translation>Mindestens {count} Paare von Dreiecken des rohen Versatzes schneiden sich, zu viele, um sie zu teilen: einen anderen Abstand oder eine größere Toleranz wählen</translation>
    </message>
    <message>
        <source>block {count} has no solid elements of {count2} nodes: give tetrahedra, pyramids, prisms or hexahedra</source>
        <translation>Block {count} hat keine Volumenelemente mit {count2} Knoten: Tetraeder, Pyramiden, Prismen oder Hexaeder angeben</translation>
    </message>
    <message>
        <source>body {count} has no triangles</source>
        <translation>Körper {count} hat keine Dreiecke</translation>
    </message>
    <message>
        <source>cancelled on request</source>
        <translation>auf Wunsch abgebrochen</translation>
    </message>
    <message>
        <source>cannot decide whether an operand encloses another: every ray tried meets an edge or a vertex; move an operand by a little</source>
        <translation>Ob ein Operand einen anderen umschließt, ist nicht zu entscheiden: jeder Strahl trifft eine Kante oder einen Eckpunkt; einen Operanden ein wenig verschieben</translation>
    </message>
    <message>
        <source>cannot finish &apos;{value}&apos;: {text}</source>
        <translation>'{value}' lässt sich nicht abschließen: {text}</translation>
    </message>
    <message>
        <source>cannot open &apos;{value}&apos;: {text}</source>
        <translation>'{value}' lässt sich nicht öffnen: {text}</translation>
    </message>
    <message>
        <source>cannot write &apos;{value}&apos;: the extension must be .stl, .ply, .obj, .off, .msh or .vtu</source>
        <translation>'{value}' lässt sich nicht schreiben: die Endung muss .stl, .ply, .obj, .off, .msh oder .vtu sein</translation>
    </message>
    <message>
        <source>cannot write &apos;{value}&apos;: {value2} is no format of meshes that is known here</source>
        <translation>'{value}' lässt sich nicht schreiben: {value2} ist kein hier bekanntes Format für Netze</translation>
    </message>
    <message>
        <source>cannot write to &apos;{value}&apos;: {text}</source>
        <translation>In '{value}' lässt sich nicht schreiben: {text}</translation>
    </message>
    <message>
        <source>element {count} names node {count2}, but there are {count3} nodes, counted from 0</source>
        <translation>Element {count} nennt Knoten {count2}, es gibt aber {count3} Knoten, gezählt ab 0</translation>
    </message>
    <message>
        <source>elements have an order of 1 to {count}, not {count2}</source>
        <translation>Elemente haben eine Ordnung von 1 bis {count}, nicht {count2}</translation>
    </message>
    <message>
        <source>elements must be an array with the nodes of one in each row</source>
        <translation>elements muss ein Feld mit den Knoten je eines Elements in jeder Zeile sein</translation>
    </message>
    <message>
        <source>it were in centimetres</source>
        <translation>es in Zentimetern wäre</translation>
    </message>
    <message>
        <source>it were in feet</source>
        <translation>es in Fuß wäre</translation>
    </message>
    <message>
        <source>it were in inches</source>
        <translation>es in Zoll wäre</translation>
    </message>
    <message>
        <source>it were in metres</source>
        <translation>es in Metern wäre</translation>
    </message>
    <message>
        <source>it were in micrometres</source>
        <translation>es in Mikrometern wäre</translation>
    </message>
    <message>
        <source>keep_edges = feature needs refinement: use the method refine, or refine_samples</source>
        <translation>keep_edges = feature braucht die Verfeinerung: die Methode refine oder refine_samples wählen</translation>
    </message>
    <message>
        <source>more than two tetrahedra of the given mesh have the triangle of nodes {count}, {count2} and {count3}: remove those that lie on one another</source>
        <translation>Mehr als zwei Tetraeder des gegebenen Netzes haben das Dreieck der Knoten {count}, {count2} und {count3}: die entfernen, die aufeinanderliegen</translation>
    </message>
    <message>
        <source>more than {count} triangles at a max. deviation of {length}: give a larger tolerance</source>
        <translation>Mehr als {count} Dreiecke bei einer größten Abweichung von {length}: eine größere Toleranz angeben</translation>
    </message>
    <message>
        <source>no point of {name} near a vertex of its mesh</source>
        <translation>Kein Punkt von {name} nahe einem Eckpunkt seines Netzes</translation>
    </message>
    <message>
        <source>no point on {name} at parameter {number}: repair the edge</source>
        <translation>Kein Punkt auf {name} beim Parameter {number}: die Kante reparieren</translation>
    </message>
    <message>
        <source>no points of {name} for a mesh edge on it</source>
        <translation>Keine Punkte von {name} für eine Netzkante darauf</translation>
    </message>
    <message>
        <source>no polynomials of degree {count} on simplices of dimension {count2}: degrees go from 0 to {count3}</source>
        <translation>keine Polynome vom Grad {count} auf Simplizes der Dimension {count2}: Grade gehen von 0 bis {count3}</translation>
    </message>
    <message>
        <source>no table for a product of degrees {count} and {count2}</source>
        <translation>keine Tabelle für ein Produkt der Grade {count} und {count2}</translation>
    </message>
    <message>
        <source>node {count} has a coordinate that is not a finite number</source>
        <translation>Knoten {count} hat eine Koordinate, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>node {count} of the mesh is not there or not finite: take its element out of the mesh</source>
        <translation>Knoten {count} des Netzes fehlt oder ist nicht endlich: sein Element aus dem Netz nehmen</translation>
    </message>
    <message>
        <source>object {count} has a vertex with coordinates that are not finite: repair or remove it</source>
        <translation>Objekt {count} hat einen Eckpunkt mit Koordinaten, die nicht endlich sind: reparieren oder entfernen</translation>
    </message>
    <message>
        <source>one of the two meshes has no triangles: there is no distance between them</source>
        <translation>Eines der beiden Netze hat keine Dreiecke: es gibt keinen Abstand zwischen ihnen</translation>
    </message>
    <message>
        <source>one of {list}</source>
        <translation>eines von {list}</translation>
    </message>
    <message>
        <source>order is {count}: it goes from 1 to {count2} for surfaces</source>
        <translation>Die Ordnung ist {count}: für Oberflächen geht sie von 1 bis {count2}</translation>
    </message>
    <message>
        <source>repair is off: only surfaces are curved without repairs, leave volume off</source>
        <translation>Die Reparatur ist aus: ohne sie werden nur Oberflächen gekrümmt, daher ohne Volumen</translation>
    </message>
    <message>
        <source>spacing is {length}: give a length above 0, at most half of the gap of {length2}</source>
        <translation>Der Abstand der Punkte ist {length}: eine Länge über 0 angeben, höchstens die Hälfte des Spalts von {length2}</translation>
    </message>
    <message>
        <source>tetrahedra of the given mesh lie outside of the shape, at {name}: give the solid that the mesh was made from</source>
        <translation>Tetraeder des gegebenen Netzes liegen außerhalb der Form, bei {name}: den Körper angeben, aus dem das Netz entstand</translation>
    </message>
    <message>
        <source>the BREP text cannot be read: {text}</source>
        <translation>Der BREP-Text lässt sich nicht lesen: {text}</translation>
    </message>
    <message>
        <source>the BREP text holds no shape</source>
        <translation>Der BREP-Text enthält keine Form</translation>
    </message>
    <message>
        <source>the division of a plane by segments is inconsistent: move the shape by a little, or choose another tolerance</source>
        <translation>Die Teilung einer Ebene durch Strecken ist widersprüchlich: die Form ein wenig verschieben oder eine andere Toleranz wählen</translation>
    </message>
    <message>
        <source>the expression of a Boolean does not join all of its {count} operands to one</source>
        <translation>Der Ausdruck einer booleschen Operation verbindet nicht alle seine {count} Operanden zu einem</translation>
    </message>
    <message>
        <source>the expression of a Boolean has {value} where there is no such operand or operation</source>
        <translation>Der Ausdruck einer booleschen Operation hat {value}, wo es keinen solchen Operanden und keine solche Operation gibt</translation>
    </message>
    <message>
        <source>the geometry engine has been shut down</source>
        <translation>der Geometriekern ist beendet</translation>
    </message>
    <message>
        <source>the given mesh does not follow the edges of the shape near {point}: give the shape that the mesh was made from, where it was, or mesh it anew</source>
        <translation>Das gegebene Netz folgt den Kanten der Form bei {point} nicht: die Form angeben, aus der das Netz entstand, am selben Ort, oder neu vernetzen</translation>
    </message>
    <message>
        <source>the given mesh does not follow {list} and others, {count} in all, near {point}: give the shape that the mesh was made from, where it was, or mesh it anew</source>
        <translation>Das gegebene Netz folgt {list} und anderen, zusammen {count}, bei {point} nicht: die Form angeben, aus der das Netz entstand, am selben Ort, oder neu vernetzen</translation>
    </message>
    <message>
        <source>the given mesh does not follow {list} near {point}: give the shape that the mesh was made from, where it was, or mesh it anew</source>
        <translation>Das gegebene Netz folgt {list} bei {point} nicht: die Form angeben, aus der das Netz entstand, am selben Ort, oder neu vernetzen</translation>
    </message>
    <message>
        <source>the given mesh has neither triangles nor tetrahedra: only these are curved</source>
        <translation>Das gegebene Netz hat weder Dreiecke noch Tetraeder: nur diese werden gekrümmt</translation>
    </message>
    <message>
        <source>the given mesh has no elements: mesh the part before curving</source>
        <translation>Das gegebene Netz hat keine Elemente: das Teil vor dem Krümmen vernetzen</translation>
    </message>
    <message>
        <source>the given mesh has no triangles on {name}: give the shape that the mesh was made from</source>
        <translation>Das gegebene Netz hat keine Dreiecke auf {name}: die Form angeben, aus der das Netz entstand</translation>
    </message>
    <message>
        <source>the given mesh has {count} triangles at {point} that lie on no face of the shape: give the shape that the mesh was made from</source>
        <translation>Das gegebene Netz hat {count} Dreiecke bei {point}, die auf keiner Fläche der Form liegen: die Form angeben, aus der das Netz entstand</translation>
    </message>
    <message>
        <source>the given mesh is {length} large, the shape {length2}, and one does not lie in the place of the other: give the shape that the mesh was made from</source>
        <translation>Das gegebene Netz ist {length} groß, die Form {length2}, und eines liegt nicht am Ort des anderen: die Form angeben, aus der das Netz entstand</translation>
    </message>
    <message>
        <source>the given mesh is {number} times larger than the shape, as if {phrase}: give mesh_scale={value}, on the command line --mesh-scale {value2}</source>
        <translation>Das gegebene Netz ist {number}-mal größer als die Form, als ob {phrase}: mesh_scale={value} angeben, auf der Befehlszeile --mesh-scale {value2}</translation>
    </message>
    <message>
        <source>the given mesh is {number} times smaller than the shape, as if {phrase}: give mesh_scale={value}, on the command line --mesh-scale {value2}</source>
        <translation>Das gegebene Netz ist {number}-mal kleiner als die Form, als ob {phrase}: mesh_scale={value} angeben, auf der Befehlszeile --mesh-scale {value2}</translation>
    </message>
    <message>
        <source>the given mesh joins tetrahedra of several solids that the shape keeps apart: give imprint=True, or the shape that the mesh was made from</source>
        <translation>Das gegebene Netz verbindet Tetraeder mehrerer Körper, die die Form getrennt hält: imprint=True angeben, oder die Form, aus der das Netz entstand</translation>
    </message>
    <message>
        <source>the given mesh lies {length} beside the shape: move one of them by about {point}</source>
        <translation>Das gegebene Netz liegt {length} neben der Form: eines von beiden um etwa {point} verschieben</translation>
    </message>
    <message>
        <source>the given mesh lies {length} off {name} at {point}: give the shape that the mesh was made from</source>
        <translation>Das gegebene Netz liegt {length} neben {name} bei {point}: die Form angeben, aus der das Netz entstand</translation>
    </message>
    <message>
        <source>the local size of {name} must be greater than 0 mm</source>
        <translation>Die lokale Größe von {name} muss größer als 0 mm sein</translation>
    </message>
    <message>
        <source>the mesh does not belong to the shape: its vertex {count} is not on {name}; give the shape that it was made from, where it was</source>
        <translation>Das Netz gehört nicht zur Form: sein Eckpunkt {count} ist nicht auf {name}; die Form angeben, aus der es entstand, am selben Ort</translation>
    </message>
    <message>
        <source>the mesh does not follow {name}</source>
        <translation>Das Netz folgt {name} nicht</translation>
    </message>
    <message>
        <source>the mesh does not say which CAD entities it lies on: curve one made by triangulate()</source>
        <translation>Das Netz sagt nicht, auf welchen CAD-Elementen es liegt: eines von triangulate() krümmen</translation>
    </message>
    <message>
        <source>the mesh does not tell which of its triangles fold: curve it anew</source>
        <translation>Das Netz sagt nicht, welche seiner Dreiecke sich falten: neu krümmen</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>Das Netz hat keine Dreiecke</translation>
    </message>
    <message>
        <source>the mesh has no triangles of orders 1 to {count} on its surface: there is nothing to measure the shape against</source>
        <translation>Das Netz hat auf seiner Oberfläche keine Dreiecke der Ordnungen 1 bis {count}: es gibt nichts, woran die Form zu messen wäre</translation>
    </message>
    <message>
        <source>the mesh that was made of the operand deviates by up to {length}, and the tolerance is {length2}: give a larger tolerance</source>
        <translation>Das Netz des Operanden weicht um bis zu {length} ab, und die Toleranz ist {length2}: eine größere Toleranz angeben</translation>
    </message>
    <message>
        <source>the mesh&apos;s origin has a coordinate that is not a finite number</source>
        <translation>Der Ursprung des Netzes hat eine Koordinate, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>the offset cannot be held in single precision without triangles that touch or cross: at least {count} triangles meet there; choose a larger tolerance, or another distance</source>
        <translation>Der Versatz passt nicht in einfache Genauigkeit, ohne dass Dreiecke sich berühren oder schneiden: mindestens {count} Dreiecke treffen sich dort; eine größere Toleranz oder einen anderen Abstand wählen</translation>
    </message>
    <message>
        <source>the offset cannot be held in single precision: {count} pairs of triangles cross there; choose a larger tolerance, or another distance</source>
        <translation>Der Versatz passt nicht in einfache Genauigkeit: {count} Paare von Dreiecken schneiden sich dort; eine größere Toleranz oder einen anderen Abstand wählen</translation>
    </message>
    <message>
        <source>the offset has triangles without area: choose another distance or tolerance</source>
        <translation>Der Versatz hat Dreiecke ohne Fläche: einen anderen Abstand oder eine andere Toleranz wählen</translation>
    </message>
    <message>
        <source>the offset lacks regions of the exact one; choose a larger tolerance, or another distance</source>
        <translation>Dem Versatz fehlen Bereiche des exakten; eine größere Toleranz oder einen anderen Abstand wählen</translation>
    </message>
    <message>
        <source>the offset needs more than {count} cells: choose a larger tolerance, or offset bodies one by one</source>
        <translation>Der Versatz braucht mehr als {count} Zellen: eine größere Toleranz wählen oder Körper einzeln versetzen</translation>
    </message>
    <message>
        <source>the operands have different origins; give all meshes in one frame</source>
        <translation>Die Operanden haben verschiedene Ursprünge; alle Netze in einem Koordinatensystem angeben</translation>
    </message>
    <message>
        <source>the pull direction has no length: give a vector such as (0, 0, 1)</source>
        <translation>Die Entformungsrichtung hat keine Länge: einen Vektor wie (0, 0, 1) angeben</translation>
    </message>
    <message>
        <source>the result cannot be held in single precision without triangles that touch or cross: at least 1 triangle of the operands meets there; choose a larger tolerance, or move an operand by a little</source>
        <translation>Das Ergebnis passt nicht in einfache Genauigkeit, ohne dass Dreiecke sich berühren oder schneiden: mindestens 1 Dreieck der Operanden trifft dort auf andere; eine größere Toleranz wählen oder einen Operanden ein wenig verschieben</translation>
    </message>
    <message>
        <source>the result cannot be held in single precision without triangles that touch or cross: at least {count} triangles of the operands meet there; choose a larger tolerance, or move an operand by a little</source>
        <translation>Das Ergebnis passt nicht in einfache Genauigkeit, ohne dass Dreiecke sich berühren oder schneiden: mindestens {count} Dreiecke der Operanden treffen sich dort; eine größere Toleranz wählen oder einen Operanden ein wenig verschieben</translation>
    </message>
    <message>
        <source>the shape to measure against has no faces</source>
        <translation>Die Form, an der gemessen wird, hat keine Flächen</translation>
    </message>
    <message>
        <source>the shape were in inches</source>
        <translation>die Form in Zoll wäre</translation>
    </message>
    <message>
        <source>the surface has no sides of {count} nodes of order {count2}: give triangles or quadrilaterals of orders 1 to {count3}</source>
        <translation>Die Oberfläche hat keine Seiten mit {count} Knoten der Ordnung {count2}: Dreiecke oder Vierecke der Ordnungen 1 bis {count3} angeben</translation>
    </message>
    <message>
        <source>the surface is not closed</source>
        <translation>die Oberfläche ist nicht geschlossen</translation>
    </message>
    <message>
        <source>the surface is not closed or not outward</source>
        <translation>die Oberfläche ist nicht geschlossen oder nicht nach außen gerichtet</translation>
    </message>
    <message>
        <source>the surface is not recovered with a reasonable number of points on it</source>
        <translation>die Oberfläche wird mit einer vernünftigen Zahl von Punkten nicht wiederhergestellt</translation>
    </message>
    <message>
        <source>the surface of {name} bounds no volume near {point}: repair it first</source>
        <translation>Die Oberfläche von {name} begrenzt bei {point} kein Volumen: zuerst reparieren</translation>
    </message>
    <message>
        <source>the surfaces do not close at the edge near {point}: move an operand by a little</source>
        <translation>Die Oberflächen schließen nicht an der Kante bei {point}: einen Operanden ein wenig verschieben</translation>
    </message>
    <message>
        <source>the system gives no more threads or memory ({text}): raise its limits, or end other programs</source>
        <translation>das System gibt keine weiteren Threads oder keinen weiteren Speicher ({text}): seine Grenzen anheben oder andere Programme beenden</translation>
    </message>
    <message>
        <source>the tetrahedra do not end at the surface</source>
        <translation>die Tetraeder enden nicht an der Oberfläche</translation>
    </message>
    <message>
        <source>the triangles of the mesh do not follow the faces of the shape: was it made from it?</source>
        <translation>Die Dreiecke des Netzes folgen den Flächen der Form nicht: ist es aus ihr entstanden?</translation>
    </message>
    <message>
        <source>there are no elements called {kind} with {count} nodes: give one of Gmsh&apos;s of order 1 to 5</source>
        <translation>Es gibt keine Elemente namens {kind} mit {count} Knoten: eines von Gmsh der Ordnungen 1 bis 5 angeben</translation>
    </message>
    <message>
        <source>there are no elements of kind &quot;{value}&quot;: name triangle, quadrilateral, tetrahedron, pyramid, prism or hexahedron</source>
        <translation>Es gibt keine Elemente der Art „{value}“: triangle, quadrilateral, tetrahedron, pyramid, prism oder hexahedron angeben</translation>
    </message>
    <message>
        <source>there is nothing to wrap: no triangle is given</source>
        <translation>Es gibt nichts einzuhüllen: kein Dreieck ist gegeben</translation>
    </message>
    <message>
        <source>triangle {count} names a vertex twice: remove degenerate triangles first</source>
        <translation>Dreieck {count} nennt einen Eckpunkt zweimal: zuerst entartete Dreiecke entfernen</translation>
    </message>
    <message>
        <source>triangle {count} names vertex {count2}, but the mesh has {count3} vertices</source>
        <translation>Dreieck {count} nennt Eckpunkt {count2}, das Netz hat aber {count3} Eckpunkte</translation>
    </message>
    <message>
        <source>two edges of the surface cross</source>
        <translation>zwei Kanten der Oberfläche schneiden sich</translation>
    </message>
    <message>
        <source>two triangles of the surface coincide</source>
        <translation>zwei Dreiecke der Oberfläche fallen zusammen</translation>
    </message>
    <message>
        <source>two vertices of the surface coincide</source>
        <translation>zwei Eckpunkte der Oberfläche fallen zusammen</translation>
    </message>
    <message>
        <source>two vertices of the surface coincide, and its inside does not part them</source>
        <translation>zwei Eckpunkte der Oberfläche fallen zusammen, und ihr Inneres trennt sie nicht</translation>
    </message>
    <message>
        <source>vertex {count} has a coordinate that is not a finite number</source>
        <translation>Eckpunkt {count} hat eine Koordinate, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>{count} elements of the given surface have the corners of others: remove them from the mesh</source>
        <translation>{count} Elemente der gegebenen Oberfläche haben die Ecken anderer: aus dem Netz entfernen</translation>
    </message>
    <message>
        <source>{count} node numbers do not make whole elements of {count2} nodes</source>
        <translation>{count} Knotennummern ergeben keine ganzen Elemente mit {count2} Knoten</translation>
    </message>
    <message>
        <source>{kind} lies on entity {count} of dimension {count2}: dimensions are 0 to 3, and entities are numbered from 0</source>
        <translation>Etwas ({kind}) liegt auf dem Gebilde {count} der Dimension {count2}: Dimensionen sind 0 bis 3, und Gebilde zählen ab 0</translation>
    </message>
    <message>
        <source>{kind} name node {count}, but the mesh has {count2} nodes</source>
        <translation>Elemente ({kind}) nennen Knoten {count}, das Netz hat aber {count2} Knoten</translation>
    </message>
    <message>
        <source>{kind} of order {count} have {count2} nodes each: {count3} are given for {count4}</source>
        <translation>Elemente ({kind}) der Ordnung {count} haben je {count2} Knoten: {count3} sind gegeben, für {count4}</translation>
    </message>
    <message>
        <source>{kind} {count} of the given mesh has a node that the mesh does not: write the mesh anew</source>
        <translation>Element {count} ({kind}) des gegebenen Netzes hat einen Knoten, den das Netz nicht hat: das Netz neu schreiben</translation>
    </message>
    <message>
        <source>{kind} {count} of the given mesh has a node whose coordinates are no finite numbers: remove it from the mesh</source>
        <translation>Element {count} ({kind}) des gegebenen Netzes hat einen Knoten, dessen Koordinaten keine endlichen Zahlen sind: aus dem Netz entfernen</translation>
    </message>
    <message>
        <source>{kind} {count} of the given mesh has one node twice: remove it from the mesh</source>
        <translation>Element {count} ({kind}) des gegebenen Netzes hat einen Knoten zweimal: aus dem Netz entfernen</translation>
    </message>
    <message>
        <source>{name} bounds no volume: where its winding number is at least 0.5, {number} % of the surface would be a guess; close it, give the sheet a thickness, or take it out</source>
        <translation>{name} begrenzt kein Volumen: wo die Windungszahl mindestens 0,5 ist, wären {number} % der Oberfläche geraten; schließen, der Fläche eine Dicke geben oder herausnehmen</translation>
    </message>
    <message>
        <source>{name} has neither a surface nor a shape</source>
        <translation>{name} hat weder eine Oberfläche noch eine Form</translation>
    </message>
    <message>
        <source>{name} has no surface. Remove it, or repair the part with Part &gt; Check geometry.</source>
        <translation>{name} hat keine Fläche. Entfernen, oder das Teil mit Part &gt; Geometrie prüfen reparieren.</translation>
    </message>
    <message>
        <source>{name} has {count} entries where {count2} are needed: give one for each</source>
        <translation>{name} hat {count} Einträge, gebraucht werden {count2}: je einen angeben</translation>
    </message>
    <message>
        <source>{name} hold {count} numbers: give {count2} for each</source>
        <translation>{name} hat {count} Zahlen: {count2} für jedes Element angeben</translation>
    </message>
    <message>
        <source>{name} is an open surface: a border of {count} edges around {point} is too large to be closed by guessing; close it, give the sheet a thickness, or take it out</source>
        <translation>{name} ist eine offene Oberfläche: ein Rand von {count} Kanten um {point} ist zu groß, um geraten zu werden; schließen, der Fläche eine Dicke geben oder herausnehmen</translation>
    </message>
    <message>
        <source>{name} is not closed or not oriented: along {value}, the line through {point} does not leave it as often as it enters; fill its holes and turn its triangles outwards first</source>
        <translation>{name} ist nicht geschlossen oder nicht orientiert: entlang {value} verlässt die Gerade durch {point} es nicht so oft, wie sie eintritt; zuerst Löcher füllen und Dreiecke nach außen drehen</translation>
    </message>
    <message>
        <source>{name} must be a positive number, not {number}</source>
        <translation>{name} muss eine positive Zahl sein, nicht {number}</translation>
    </message>
    <message>
        <source>{name} must have {count} numbers in each row</source>
        <translation>{name} muss {count} Zahlen in jeder Zeile haben</translation>
    </message>
    <message>
        <source>{name}: the surface has one side only, like a Moebius strip, near {point}; an operand must enclose a volume</source>
        <translation>{name}: die Oberfläche hat bei {point} nur eine Seite, wie ein Möbiusband; ein Operand muss ein Volumen umschließen</translation>
    </message>
    <message>
        <source>{name}: vertex {count} has a coordinate beyond {length}, up to which Booleans are exact; give a smaller mesh</source>
        <translation>{name}: Eckpunkt {count} hat eine Koordinate über {length}, bis zu denen boolesche Operationen exakt sind; ein kleineres Netz angeben</translation>
    </message>
    <message>
        <source>{name}: {phrase}</source>
        <translation>{name}: {phrase}</translation>
    </message>
    <message>
        <source>{phrase}; sampling it along rays fails, too: {phrase2}</source>
        <translation>{phrase}; auch das Abtasten entlang von Strahlen misslingt: {phrase2}</translation>
    </message>
    <message>
        <source>{solid} cannot be filled anew after its surface was repaired: {phrase}</source>
        <translation>{solid} lässt sich nach der Reparatur seiner Oberfläche nicht neu füllen: {phrase}</translation>
    </message>
    <message>
        <source>{value} files do not hold elements of kind {kind} and order {count}: use .msh or .vtu</source>
        <translation>{value}-Dateien fassen keine Elemente der Art {kind} und der Ordnung {count}: .msh oder .vtu verwenden</translation>
    </message>
    <message>
        <source>1 of {count2} edges is smooth and does not constrain the mesh (keep_edges = feature)</source>
        <translation>1 von {count2} Kanten ist glatt und bindet das Netz nicht (keep_edges = feature)</translation>
    </message>
    <message>
        <source>1 of {count2} edges is smooth, but constrains the mesh all the same: otherwise faces would cross</source>
        <translation>1 von {count2} Kanten ist glatt, bindet das Netz aber trotzdem: sonst würden Flächen sich schneiden</translation>
    </message>
    <message>
        <source>1 other on the meshes of the shapes</source>
        <translation>1 weiterer auf den Netzen der Formen</translation>
    </message>
    <message>
        <source>an operand has more digits than single precision holds: to_mesh and most files round the result</source>
        <translation>Ein Operand hat mehr Stellen, als einfache Genauigkeit hält: to_mesh und die meisten Dateien runden das Ergebnis</translation>
    </message>
    <message>
        <source>bodies overlap: {list}</source>
        <translation>Körper überlappen sich: {list}</translation>
    </message>
    <message>
        <source>bodies touch: 1 pair of triangles of faces that lie on each other cross by their chords; imprint gives both bodies the same triangles</source>
        <translation>Körper berühren sich: 1 Paar von Dreiecken aufeinanderliegender Flächen schneidet sich durch seine Sehnen; imprint gibt beiden Körpern dieselben Dreiecke</translation>
    </message>
    <message>
        <source>bodies touch: {count} pairs of triangles of faces that lie on each other cross by their chords; imprint gives both bodies the same triangles</source>
        <translation>Körper berühren sich: {count} Paare von Dreiecken aufeinanderliegender Flächen schneiden sich durch ihre Sehnen; imprint gibt beiden Körpern dieselben Dreiecke</translation>
    </message>
    <message>
        <source>edges of {name} deviate from it by more than that</source>
        <translation>Kanten von {name} weichen um mehr davon ab</translation>
    </message>
    <message>
        <source>edges swapped: {count}, collapsed: {count2}, halved: {count3}; vertices moved: {count4}</source>
        <translation>Kanten getauscht: {count}, zusammengezogen: {count2}, halbiert: {count3}; Eckpunkte verschoben: {count4}</translation>
    </message>
    <message>
        <source>faces that lie on each other within the tolerance were taken as one: slivers and gaps up to {length} thin may be gone</source>
        <translation>Flächen, die innerhalb der Toleranz aufeinanderliegen, gelten als eine: Splitter und Spalten bis {length} Dicke können fehlen</translation>
    </message>
    <message>
        <source>filled in the reconstruction: 1 hole</source>
        <translation>beim Wiederaufbau gefüllt: 1 Loch</translation>
    </message>
    <message>
        <source>filled in the reconstruction: {count} holes</source>
        <translation>beim Wiederaufbau gefüllt: {count} Löcher</translation>
    </message>
    <message>
        <source>lost, as no ray met the components that they belong to: 1 triangle; take a higher resolution</source>
        <translation>Verloren, da kein Strahl ihre Komponenten traf: 1 Dreieck; eine höhere Auflösung wählen</translation>
    </message>
    <message>
        <source>lost, as no ray met the components that they belong to: {count} triangles; take a higher resolution</source>
        <translation>Verloren, da kein Strahl ihre Komponenten traf: {count} Dreiecke; eine höhere Auflösung wählen</translation>
    </message>
    <message>
        <source>max. deviation {length} instead of the requested {length2}: {phrase}</source>
        <translation>Größte Abweichung {length} statt der verlangten {length2}: {phrase}</translation>
    </message>
    <message>
        <source>mending of angles ended at its limit of attempts: 1 triangle below the smallest angle asked for might be improvable</source>
        <translation>Das Verbessern von Winkeln endete an der Grenze seiner Versuche: 1 Dreieck unter dem verlangten kleinsten Winkel wäre vielleicht zu verbessern</translation>
    </message>
    <message>
        <source>mending of angles ended at its limit of attempts: {count} triangles below the smallest angle asked for might be improvable</source>
        <translation>Das Verbessern von Winkeln endete an der Grenze seiner Versuche: {count} Dreiecke unter dem verlangten kleinsten Winkel wären vielleicht zu verbessern</translation>
    </message>
    <message>
        <source>open, as no repair closes it: {list}; inside is where its winding number is at least 0.5, and this guess spans the holes: {number} % of the result&apos;s surface</source>
        <translation>Offen, da keine Reparatur es schließt: {list}; innen ist, wo die Windungszahl mindestens 0,5 ist, und dies überspannt die Löcher: {number} % der Oberfläche des Ergebnisses</translation>
    </message>
    <message>
        <source>refine_samples is off, so that the samples alone decide</source>
        <translation>refine_samples ist aus, sodass allein die Abtastpunkte entscheiden</translation>
    </message>
    <message>
        <source>repaired before it was measured: {list}</source>
        <translation>vor der Messung repariert: {list}</translation>
    </message>
    <message>
        <source>repaired before: {list}</source>
        <translation>zuvor repariert: {list}</translation>
    </message>
    <message>
        <source>sampled along rays (method uniform), as there is no exact result: {phrase}</source>
        <translation>Entlang von Strahlen abgetastet (Methode uniform), da es kein exaktes Ergebnis gibt: {phrase}</translation>
    </message>
    <message>
        <source>sampled on CAD faces: 1 sample</source>
        <translation>abgetastet auf CAD-Flächen: 1 Punkt</translation>
    </message>
    <message>
        <source>sampled on CAD faces: {count} samples</source>
        <translation>abgetastet auf CAD-Flächen: {count} Punkte</translation>
    </message>
    <message>
        <source>sampling ended at max_triangles = {count}: the mesh is consistent, but coarser than requested; raise max_triangles</source>
        <translation>Das Abtasten endete bei max_triangles = {count}: das Netz ist widerspruchsfrei, aber gröber als verlangt; max_triangles erhöhen</translation>
    </message>
    <message>
        <source>some edges cannot be split without folding or crowding the mesh</source>
        <translation>manche Kanten lassen sich nicht teilen, ohne das Netz zu falten oder zu drängen</translation>
    </message>
    <message>
        <source>stopped at max_triangles = {count}: the mesh is consistent, but not all limits are met, and it was not searched for triangles that cross; raise max_triangles</source>
        <translation>Angehalten bei max_triangles = {count}: das Netz ist widerspruchsfrei, aber nicht alle Grenzen sind eingehalten, und nach sich schneidenden Dreiecken wurde nicht gesucht; max_triangles erhöhen</translation>
    </message>
    <message>
        <source>the coarsest mesh of this shape takes more than max_triangles = {count}: the mesh is consistent, but not all limits are met, and it was not searched for triangles that cross; raise max_triangles</source>
        <translation>Das gröbste Netz dieser Form braucht mehr als max_triangles = {count}: das Netz ist widerspruchsfrei, aber nicht alle Grenzen sind eingehalten, und nach sich schneidenden Dreiecken wurde nicht gesucht; max_triangles erhöhen</translation>
    </message>
    <message>
        <source>the hollow is closed: powder, resin or air cannot leave it; name openings, or cut holes by boolean</source>
        <translation>Die Höhlung ist geschlossen: Pulver, Harz oder Luft kommen nicht heraus; Öffnungen nennen oder Löcher durch eine boolesche Operation schneiden</translation>
    </message>
    <message>
        <source>the mesh was kept as it was at 1 triangle, which would cross others or have smaller angles than any before</source>
        <translation>Das Netz blieb an 1 Dreieck, wie es war: es würde andere schneiden oder kleinere Winkel haben als alle zuvor</translation>
    </message>
    <message>
        <source>the mesh was kept as it was at {count} triangles, which would cross others or have smaller angles than any before</source>
        <translation>Das Netz blieb an {count} Dreiecken, wie es war: sie würden andere schneiden oder kleinere Winkel haben als alle zuvor</translation>
    </message>
    <message>
        <source>the part is so thin that single precision changes its volume from {volume} to {volume2}: it holds coordinates of this part to {length}</source>
        <translation>Das Teil ist so dünn, dass einfache Genauigkeit sein Volumen von {volume} auf {volume2} ändert: sie hält Koordinaten dieses Teils auf {length} genau</translation>
    </message>
    <message>
        <source>the rays of three directions disagree at 1 node of the grid</source>
        <translation>die Strahlen dreier Richtungen widersprechen sich an 1 Knoten des Gitters</translation>
    </message>
    <message>
        <source>the rays of three directions disagree at {count} nodes of the grid</source>
        <translation>die Strahlen dreier Richtungen widersprechen sich an {count} Knoten des Gitters</translation>
    </message>
    <message>
        <source>the result is empty: no point of the solid is {length} away from its surface</source>
        <translation>Das Ergebnis ist leer: kein Punkt des Körpers ist {length} von seiner Oberfläche entfernt</translation>
    </message>
    <message>
        <source>the result is empty: no volume is left</source>
        <translation>Das Ergebnis ist leer: kein Volumen bleibt übrig</translation>
    </message>
    <message>
        <source>the result is empty: nothing of what is given is as large as the tolerance</source>
        <translation>Das Ergebnis ist leer: nichts des Gegebenen ist so groß wie die Toleranz</translation>
    </message>
    <message>
        <source>the result is empty: the operands are the same within the tolerance of {length}; a smaller tolerance shows smaller differences</source>
        <translation>Das Ergebnis ist leer: die Operanden sind innerhalb der Toleranz von {length} gleich; eine kleinere Toleranz zeigt kleinere Unterschiede</translation>
    </message>
    <message>
        <source>the result is not a closed manifold surface: see its faults</source>
        <translation>Das Ergebnis ist keine geschlossene mannigfaltige Oberfläche: siehe seine Fehler</translation>
    </message>
    <message>
        <source>the straight mesh has triangles on one another: a finer one was not tried</source>
        <translation>Das gerade Netz hat aufeinanderliegende Dreiecke: ein feineres wurde nicht versucht</translation>
    </message>
    <message>
        <source>the straight mesh was made finer {count} times</source>
        <translation>Das gerade Netz wurde {count}-mal feiner gemacht</translation>
    </message>
    <message>
        <source>there is no hollow: the solid is nowhere thicker than two walls</source>
        <translation>Es gibt keine Höhlung: der Körper ist nirgends dicker als zwei Wände</translation>
    </message>
    <message>
        <source>triangles of the surface were not repaired, as tetrahedra would not fit: {phrase}</source>
        <translation>Dreiecke der Oberfläche wurden nicht repariert, da Tetraeder nicht passen würden: {phrase}</translation>
    </message>
    <message>
        <source>{count} elements of the given mesh lie on one another and have no outside</source>
        <translation>{count} Elemente des gegebenen Netzes liegen aufeinander und haben kein Außen</translation>
    </message>
    <message>
        <source>{count} elements of the given mesh were numbered the wrong way round</source>
        <translation>{count} Elemente des gegebenen Netzes waren verkehrt herum nummeriert</translation>
    </message>
    <message>
        <source>{count} faces of the shape have no triangles in the given mesh, the first is {name}</source>
        <translation>{count} Flächen der Form haben im gegebenen Netz keine Dreiecke, die erste ist {name}</translation>
    </message>
    <message>
        <source>{count} of {count2} edges are smooth and do not constrain the mesh (keep_edges = feature)</source>
        <translation>{count} von {count2} Kanten sind glatt und binden das Netz nicht (keep_edges = feature)</translation>
    </message>
    <message>
        <source>{count} of {count2} edges are smooth, but constrain the mesh all the same: otherwise faces would cross</source>
        <translation>{count} von {count2} Kanten sind glatt, binden das Netz aber trotzdem: sonst würden Flächen sich schneiden</translation>
    </message>
    <message>
        <source>{count} operands are shapes: their meshes deviate by at most {length} from them; the max. deviation is that of the Boolean of the meshes</source>
        <translation>{count} Operanden sind Formen: ihre Netze weichen um höchstens {length} von ihnen ab; die größte Abweichung ist die der booleschen Operation mit den Netzen</translation>
    </message>
    <message>
        <source>{count} others on the meshes of the shapes</source>
        <translation>{count} weitere auf den Netzen der Formen</translation>
    </message>
    <message>
        <source>{count} pairs of curved triangles cross, one on {name} and {name2} near {point}</source>
        <translation>{count} Paare gekrümmter Dreiecke schneiden sich, eines auf {name} und {name2} bei {point}</translation>
    </message>
    <message>
        <source>{count} pairs of curved triangles were not compared to the end, as where bodies lie on each other: certify compares more</source>
        <translation>{count} Paare gekrümmter Dreiecke wurden nicht zu Ende verglichen, etwa wo Körper aufeinanderliegen: certify vergleicht mehr</translation>
    </message>
    <message>
        <source>{count} tetrahedra of the given mesh lie on one another and have no outside: they are removed</source>
        <translation>{count} Tetraeder des gegebenen Netzes liegen aufeinander und haben kein Außen: sie werden entfernt</translation>
    </message>
    <message>
        <source>{list}: at most about {length} wide, for which the mesh has {count} of its {count2} triangles: take such faces out of the shape</source>
        <translation>{list}: höchstens etwa {length} breit; dafür hat das Netz {count} seiner {count2} Dreiecke: solche Flächen aus der Form nehmen</translation>
    </message>
    <message>
        <source>{list}: at most about {length} wide, for which the mesh has {count} of its {count2} triangles: take such faces out of the shape, or allow a max. deviation of {length2}, at which they count as edges</source>
        <translation>{list}: höchstens etwa {length} breit; dafür hat das Netz {count} seiner {count2} Dreiecke: solche Flächen aus der Form nehmen oder eine größte Abweichung von {length2} erlauben, bei der sie als Kanten zählen</translation>
    </message>
    <message>
        <source>{list}: meshed neither by us nor by OpenCASCADE, and left out ({phrase})</source>
        <translation>{list}: weder von uns noch von OpenCASCADE vernetzt und ausgelassen ({phrase})</translation>
    </message>
    <message>
        <source>{list}: not meshed; OpenCASCADE&apos;s triangulation is taken, which may have holes ({phrase})</source>
        <translation>{list}: nicht vernetzt; stattdessen gilt die Triangulierung von OpenCASCADE, die Löcher haben kann ({phrase})</translation>
    </message>
    <message>
        <source>{list}: shorter than {length}, which does not show at what is asked for: a vertex in the mesh</source>
        <translation>{list}: kürzer als {length}, was bei dem Verlangten nicht zu sehen ist: im Netz ein Eckpunkt</translation>
    </message>
    <message>
        <source>{name} and {name2} are one body twice</source>
        <translation>{name} und {name2} sind zweimal derselbe Körper</translation>
    </message>
    <message>
        <source>{name} and {name2} cross in 1 pair of triangles</source>
        <translation>{name} und {name2} schneiden sich in 1 Paar von Dreiecken</translation>
    </message>
    <message>
        <source>{name} and {name2} cross in {count} pairs of triangles</source>
        <translation>{name} und {name2} schneiden sich in {count} Paaren von Dreiecken</translation>
    </message>
    <message>
        <source>{name} and {name2} cross where they are apart by less than the mesh deviates</source>
        <translation>{name} und {name2} schneiden sich, wo sie um weniger auseinanderliegen, als das Netz abweicht</translation>
    </message>
    <message>
        <source>{name} and {name2} overlap</source>
        <translation>{name} und {name2} überlappen sich</translation>
    </message>
    <message>
        <source>{name} crosses itself in 1 pair of triangles</source>
        <translation>{name} schneidet sich selbst in 1 Paar von Dreiecken</translation>
    </message>
    <message>
        <source>{name} crosses itself in {count} pairs of triangles</source>
        <translation>{name} schneidet sich selbst in {count} Paaren von Dreiecken</translation>
    </message>
    <message>
        <source>{name} deviates {length} from the edges or faces at it, within its tolerance, and {count} more likewise: elements there leave the shape to reach it</source>
        <translation>{name} weicht {length} von den Kanten oder Flächen daran ab, innerhalb der Toleranz, und {count} weitere ebenso: Elemente dort verlassen die Form, um es zu erreichen</translation>
    </message>
    <message>
        <source>{name} deviates {length} from the edges or faces at it, within its tolerance: elements there leave the shape to reach it</source>
        <translation>{name} weicht {length} von den Kanten oder Flächen daran ab, innerhalb der Toleranz: Elemente dort verlassen die Form, um es zu erreichen</translation>
    </message>
    <message>
        <source>{name} holds shapes and meshes: the mesh of the shapes deviates by at most {length} from them, and its volume by about {number} %; the max. deviation is that of the Boolean of the meshes</source>
        <translation>{name} enthält Formen und Netze: das Netz der Formen weicht um höchstens {length} von ihnen ab und sein Volumen um etwa {number} %; die größte Abweichung ist die der booleschen Operation mit den Netzen</translation>
    </message>
    <message>
        <source>{name} holds shapes and meshes: the mesh of the shapes deviates by at most {length} from them; the max. deviation is that of the Boolean of the meshes</source>
        <translation>{name} enthält Formen und Netze: das Netz der Formen weicht um höchstens {length} von ihnen ab; die größte Abweichung ist die der booleschen Operation mit den Netzen</translation>
    </message>
    <message>
        <source>{name} is a point in single precision: left out</source>
        <translation>{name} ist in einfacher Genauigkeit ein Punkt: ausgelassen</translation>
    </message>
    <message>
        <source>{name} is a shape: its mesh deviates by at most {length} from it, and its volume by about {number} %; the max. deviation is that of the Boolean of the meshes</source>
        <translation>{name} ist eine Form: ihr Netz weicht um höchstens {length} von ihr ab und sein Volumen um etwa {number} %; die größte Abweichung ist die der booleschen Operation mit den Netzen</translation>
    </message>
    <message>
        <source>{name} is a shape: its mesh deviates by at most {length} from it; the max. deviation is that of the Boolean of the meshes</source>
        <translation>{name} ist eine Form: ihr Netz weicht um höchstens {length} von ihr ab; die größte Abweichung ist die der booleschen Operation mit den Netzen</translation>
    </message>
    <message>
        <source>{name} is missing: {text}</source>
        <translation>{name} fehlt: {text}</translation>
    </message>
    <message>
        <source>{name} lies inside {name2}</source>
        <translation>{name} liegt in {name2}</translation>
    </message>
    <message>
        <source>{name}, {phrase}</source>
        <translation>{name}, {phrase}</translation>
    </message>
    <message>
        <source>too many triangles meet: not all pairs were compared</source>
        <translation>Zu viele Dreiecke treffen sich: nicht alle Paare wurden verglichen</translation>
    </message>
    <message>
        <source>FreeCAD has OpenCASCADE {value}, the core {value2}</source>
        <translation>FreeCAD hat OpenCASCADE {value}, der Kern {value2}</translation>
    </message>
    <message>
        <source>MESHQUALITY_BRIDGE is &apos;live&apos;, which does not work here: {phrase}; do not set it, and shapes are copied</source>
        <translation>MESHQUALITY_BRIDGE ist 'live', was hier nicht geht: {phrase}; ohne diese Variable werden Formen kopiert</translation>
    </message>
    <message>
        <source>the binary BREP of the shape cannot be read: {text}</source>
        <translation>das binäre BREP der Form kann nicht gelesen werden: {text}</translation>
    </message>
    <message>
        <source>the core has an OpenCASCADE of its own</source>
        <translation>der Kern hat ein eigenes OpenCASCADE</translation>
    </message>
    <message>
        <source>the shape cannot be written as binary BREP: {text}</source>
        <translation>die Form kann nicht als binäres BREP geschrieben werden: {text}</translation>
    </message>
    <message>
        <source>this build of FreeCAD cannot share its shapes</source>
        <translation>dieser Bau von FreeCAD kann seine Formen nicht teilen</translation>
    </message>
    <message>
        <source>a CFD surface of {name} would end FreeCAD when it is undone, unless MeshQuality was built for this FreeCAD: write the mesh with its patches as STL, or an OpenFOAM case</source>
        <translation>eine CFD-Oberfläche von {name} würde FreeCAD beim Rückgängigmachen beenden, wenn MeshQuality nicht für dieses FreeCAD gebaut ist: schreiben Sie das Netz mit seinen Patches als STL oder einen OpenFOAM-Fall</translation>
    </message>
    <message>
        <source>1 exempt triangle</source>
        <translation>1 ausgenommenes Dreieck</translation>
    </message>
    <message>
        <source>elements of order {count}</source>
        <translation>Elemente der Ordnung {count}</translation>
    </message>
    <message>
        <source>left out, as they have no faces: {list}</source>
        <translation>ausgelassen, da ohne Flächen: {list}</translation>
    </message>
    <message>
        <source>not watertight</source>
        <translation>nicht wasserdicht</translation>
    </message>
    <message>
        <source>nothing to export: select an object with faces or a mesh</source>
        <translation>Nichts zu exportieren: Wählen Sie ein Objekt mit Flächen oder ein Netz</translation>
    </message>
    <message>
        <source>requested before curving: smallest angle {number}°, max. deviation {length}</source>
        <translation>verlangt vor dem Krümmen: kleinster Winkel {number}°, max. Abweichung {length}</translation>
    </message>
    <message>
        <source>requested: smallest angle {number}°, max. deviation {length}</source>
        <translation>verlangt: kleinster Winkel {number}°, max. Abweichung {length}</translation>
    </message>
    <message>
        <source>watertight</source>
        <translation>wasserdicht</translation>
    </message>
    <message>
        <source>{count} exempt triangles</source>
        <translation>{count} ausgenommene Dreiecke</translation>
    </message>
    <message>
        <source>{name} is a FEM mesh, which goes into a file of its own: select it alone</source>
        <translation>{name} ist ein FEM-Netz, das in eine eigene Datei kommt: Wählen Sie es allein</translation>
    </message>
    <message>
        <source>{face} to {face2} of all that is exported</source>
        <translation>{face} bis {face2} von allem, was exportiert wird</translation>
    </message>
    <message>
        <source>Narrow corners</source>
        <translation>Schmale Ecken</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>The colours end at ± {0}.</source>
        <translation>Die Farben enden bei ± {0}.</translation>
    </message>
    <message>
        <source>Deviation from the part</source>
        <translation>Abweichung vom Teil</translation>
    </message>
    <message>
        <source>Signed distance from the part: red outside, blue inside.</source>
        <translation>Abstand vom Teil mit Vorzeichen: außen rot, innen blau.</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Best fit from any pose</source>
        <translation>Einpassen aus jeder Lage</translation>
    </message>
    <message>
        <source>Best fit from here</source>
        <translation>Einpassen von hier aus</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Largest distance between the given mesh and the simplified one</source>
        <translation>Größter Abstand zwischen dem gegebenen und dem vereinfachten Netz</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Points farther from the reference than this, outside or inside, are reported</source>
        <translation>Punkte, die außen oder innen weiter von der Referenz entfernt sind, werden gemeldet</translation>
    </message>
    <message>
        <source>Sources is incomplete: choose a scan, and the part that it is measured against</source>
        <translation>Sources ist unvollständig: Wählen Sie einen Scan und das Teil, gegen das er gemessen wird</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>aligned: root mean square {length} of {count} points</source>
        <translation>ausgerichtet: quadratisches Mittel {length} von {count} Punkten</translation>
    </message>
    <message>
        <source>aligning the points</source>
        <translation>Punkte werden ausgerichtet</translation>
    </message>
    <message>
        <source>max. deviation {length} (allowed {length2}): {number} % of the points are beyond.</source>
        <translation>max. Abweichung {length} (erlaubt {length2}): {number} % der Punkte liegen darüber.</translation>
    </message>
    <message>
        <source>none: points are measured where they are; near: they are fitted to the reference from there; any: from any pose, by principal axes first</source>
        <translation>none: Punkte werden dort gemessen, wo sie sind; near: sie werden von dort aus in die Referenz eingepasst; any: aus jeder Lage, zuerst nach den Hauptachsen</translation>
    </message>
    <message>
        <source>preparing the part that is measured against</source>
        <translation>Teil, gegen das gemessen wird, wird vorbereitet</translation>
    </message>
    <message>
        <source>the mesh is not manifold and oriented at {count} edges or triangles: repair it first</source>
        <translation>Das Netz ist an {count} Kanten oder Dreiecken nicht mannigfaltig und ausgerichtet: Reparieren Sie es zuerst</translation>
    </message>
    <message>
        <source>{name} cannot be aligned with {name2}: after {count} steps its points are {length} off (root mean square). Move it near to where it belongs and align it from there, give pairs of points, or check its unit</source>
        <translation>{name} lässt sich nicht an {name2} ausrichten: nach {count} Schritten liegen die Punkte {length} daneben (quadratisches Mittel). Schieben Sie es in die Nähe seiner Lage und richten Sie es von dort aus, geben Sie Punktpaare an oder prüfen Sie die Einheit</translation>
    </message>
    <message>
        <source>{name} deviation</source>
        <translation>{name} Abweichung</translation>
    </message>
    <message>
        <source>{name} has no points</source>
        <translation>{name} hat keine Punkte</translation>
    </message>
    <message>
        <source>{name} has points whose coordinates are no numbers: leave these out</source>
        <translation>{name} hat Punkte, deren Koordinaten keine Zahlen sind: Lassen Sie diese weg</translation>
    </message>
    <message>
        <source>{name} is no mesh and no point cloud: choose a scan, and the part that it is measured against</source>
        <translation>{name} ist weder ein Netz noch eine Punktwolke: Wählen Sie einen Scan und das Teil, gegen das er gemessen wird</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Seitenverhältnis (Verdict)</translation>
    </message>
    <message>
        <source>Longest edge over the size of the inscribed circle or ball, by Verdict: 1 = regular.</source>
        <translation>Längste Kante zur Größe des Inkreises oder der Inkugel, nach Verdict: 1 = regelmäßig.</translation>
    </message>
    <message>
        <source>Scaled Jacobian of the corners</source>
        <translation>Jacobi-Determinante der Ecken</translation>
    </message>
    <message>
        <source>By Verdict: 1 = regular, ≤ 0 = folded.</source>
        <translation>Nach Verdict: 1 = regelmäßig, ≤ 0 = gefaltet.</translation>
    </message>
    <message>
        <source>Equiangle skew</source>
        <translation>Winkelverzerrung</translation>
    </message>
    <message>
        <source>How far angles are from those of the regular element: 0 = none, 1 = flat.</source>
        <translation>Abweichung der Winkel von denen der regelmäßigen Form: 0 = keine, 1 = flach.</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Between two sides of an element; near 180° it is flat.</source>
        <translation>Zwischen zwei Seiten; nahe 180° ist die Form flach.</translation>
    </message>
    <message>
        <source>Skew</source>
        <translation>Schiefe der Achsen</translation>
    </message>
    <message>
        <source>Cosine of the angle between the axes of quadrilaterals and hexahedra: 0 = square.</source>
        <translation>Kosinus des Winkels zwischen den Achsen von Vierecken und Hexaedern: 0 = rechtwinklig.</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Verjüngung</translation>
    </message>
    <message>
        <source>Difference of opposite sides of quadrilaterals and hexahedra: 0 = none.</source>
        <translation>Unterschied gegenüberliegender Seiten von Vierecken und Hexaedern: 0 = keiner.</translation>
    </message>
    <message>
        <source>Warpage</source>
        <translation>Verwindung</translation>
    </message>
    <message>
        <source>Of quadrilaterals, also as faces of volumes: 0 = flat.</source>
        <translation>Von Vierecken, auch als Flächen von Volumen: 0 = eben.</translation>
    </message>
    <message>
        <source>Non-orthogonality</source>
        <translation>Nichtorthogonalität</translation>
    </message>
    <message>
        <source>OpenFOAM's: angle between a face and the line between the centres of its elements; 70° is much.</source>
        <translation>Nach OpenFOAM: Winkel zwischen einer Fläche und der Linie durch die Mitten ihrer Elemente; 70° ist viel.</translation>
    </message>
    <message>
        <source>Skewness</source>
        <translation>Schiefe</translation>
    </message>
    <message>
        <source>OpenFOAM&apos;s: how far that line misses the middle of the face; 4 is much.</source>
        <translation>Nach OpenFOAM: wie weit diese Linie die Mitte der Fläche verfehlt; 4 ist viel.</translation>
    </message>
    <message>
        <source>Save values...</source>
        <translation>Werte...</translation>
    </message>
    <message>
        <source>Write all measures of each element into a table, as CSV</source>
        <translation>Alle Maße der Dreiecke oder Volumen in eine Tabelle schreiben, als CSV</translation>
    </message>
    <message>
        <source>Save report...</source>
        <translation>Bericht speichern...</translation>
    </message>
    <message>
        <source>Save values</source>
        <translation>Werte speichern</translation>
    </message>
    <message>
        <source>Saved: {0}</source>
        <translation>Gespeichert: {0}</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>All requested limits are met</source>
        <translation>Alle geforderten Grenzen sind eingehalten</translation>
    </message>
    <message>
        <source>By face</source>
        <translation>Nach Fläche</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Crossing pairs of triangles</source>
        <translation>Paare von Dreiecken, die sich schneiden</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Grey: no value there.</source>
        <translation>Grau: dort ist kein Wert.</translation>
    </message>
    <message>
        <source>Largest distance between the mesh and the part, on one side of it</source>
        <translation>Größter Abstand zwischen dem Netz und dem Teil, auf einer Seite des Teils</translation>
    </message>
    <message>
        <source>Manifold</source>
        <translation>Mannigfaltig</translation>
    </message>
    <message>
        <source>Max. deviation, proven</source>
        <translation>Max. Abweichung, bewiesen</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Never inside the part</source>
        <translation>Nie im Teil</translation>
    </message>
    <message>
        <source>Never outside the part</source>
        <translation>Nie außerhalb des Teils</translation>
    </message>
    <message>
        <source>No limits were requested</source>
        <translation>Es waren keine Grenzen gefordert</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <source>Report: {name}</source>
        <translation>Bericht: {name}</translation>
    </message>
    <message>
        <source>Requested</source>
        <translation>Gefordert</translation>
    </message>
    <message>
        <source>SHA-256 of the vertices (float64) and triangles (int32)</source>
        <translation>SHA-256 der Ecken (float64) und Dreiecke (int32)</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Target not decided</source>
        <translation>Ziel nicht entschieden</translation>
    </message>
    <message>
        <source>Target not met</source>
        <translation>Ziel nicht erreicht</translation>
    </message>
    <message>
        <source>The whole report</source>
        <translation>Der ganze Bericht</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Versions and digest</source>
        <translation>Versionen und Prüfsumme</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>never inside the part: every point of the mesh is {length} to {length2} outside of it</source>
        <translation>nie im Teil: jeder Punkt des Netzes liegt {length} bis {length2} außerhalb</translation>
    </message>
    <message>
        <source>never outside the part: every point of the mesh is {length} to {length2} inside of it</source>
        <translation>nie außerhalb des Teils: jeder Punkt des Netzes liegt {length} bis {length2} innerhalb</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>outside: a tool that touches the mesh never cuts into the part; inside: the mesh never sticks out of it</source>
        <translation>Nie im Teil: ein Werkzeug, das das Netz berührt, schneidet nie in das Teil; nie außerhalb: das Netz ragt nie heraus</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>{count} of {count2} are shown.</source>
        <translation>{count} von {count2} sind gezeigt.</translation>
    </message>
    <message>
        <source>{count} of {count2} triangles are left; no point of either surface is farther than {length} from the other one</source>
        <translation>{count} von {count2} Dreiecken bleiben; kein Punkt einer der beiden Oberflächen ist weiter als {length} von der anderen entfernt</translation>
    </message>
    <message>
        <source>{name} CAM mesh</source>
        <translation>{name} CAM-Netz</translation>
    </message>
    <message>
        <source>{name} simplified</source>
        <translation>{name} vereinfacht</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Add a region: inside of the selected solids, or near the selected faces, edges and points</source>
        <translation>Einen Bereich hinzufügen: in den gewählten Volumenkörpern, oder nahe den gewählten Flächen, Kanten und Punkten</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Draw the sizes as coloured points, and count the triangles to expect</source>
        <translation>Die Größen als farbige Punkte zeichnen, und die zu erwartenden Dreiecke zählen</translation>
    </message>
    <message>
        <source>A size is a length above 0.</source>
        <translation>Eine Größe ist eine Länge über 0.</translation>
    </message>
    <message>
        <source>Select solids, or faces, edges or points, in the 3D view first.</source>
        <translation>Wählen Sie zuerst Volumenkörper, oder Flächen, Kanten oder Punkte, in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Check a region first.</source>
        <translation>Haken Sie zuerst einen Bereich an.</translation>
    </message>
    <message>
        <source>Sizes from {0} (red) to {1} (blue); about {2} triangles by these regions</source>
        <translation>Größen von {0} (rot) bis {1} (blau); etwa {2} Dreiecke nach diesen Bereichen</translation>
    </message>
    <message>
        <source>Lengths of edges by place: Size regions of the document, or files of points with columns x, y, z, size or of meshes with an array of sizes; the least of all holds</source>
        <translation>Kantenlängen nach Ort: Größenbereiche des Dokuments, oder Dateien von Punkten mit den Spalten x, y, z, size oder von Netzen mit einem Feld von Größen; die kleinste von allen gilt</translation>
    </message>
    <message>
        <source>Size field</source>
        <translation>Größenfeld</translation>
    </message>
    <message>
        <source>edges up to {number} times the size field ({number2} promised), at ({phrase}) mm.</source>
        <translation>Kanten bis zum {number}-Fachen des Größenfelds (zugesagt {number2}), bei ({phrase}) mm.</translation>
    </message>
    <message>
        <source>names of Size regions of the document, or paths of files</source>
        <translation>Namen von Größenbereichen des Dokuments, oder Pfade von Dateien</translation>
    </message>
    <message>
        <source>sampling the size field</source>
        <translation>Größenfeld abtasten</translation>
    </message>
    <message>
        <source>these numbers are no size field: its cells form no octree, or a size is not above 0 mm</source>
        <translation>diese Zahlen sind kein Größenfeld: seine Zellen bilden keinen Octree, oder eine Größe liegt nicht über 0 mm</translation>
    </message>
    <message>
        <source>Corners of faces below the smallest angle: keep them, each with one triangle of that angle; cut them off by a twentieth of the distance, where the faces beside them allow it; or do so (auto) where further triangles would be below the smallest angle</source>
        <translation>Ecken von Flächen unter dem kleinsten Winkel: behalten, jede mit einem Dreieck dieses Winkels; um ein Zwanzigstel des Abstands abschneiden, wo die Flächen daneben es zulassen; oder dies nur dort (auto), wo sonst weitere Dreiecke unter dem kleinsten Winkel lägen</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>abgeschnitten</translation>
    </message>
    <message>
        <source>cut off where needed</source>
        <translation>wo nötig abgeschnitten</translation>
    </message>
    <message>
        <source>growing layers on the walls</source>
        <translation>Schichten wachsen an den Wänden</translation>
    </message>
    <message>
        <source>Order of insertion</source>
        <translation>Reihenfolge der Punkte</translation>
    </message>
    <message>
        <source>Triangles with small angles get their points in rounds, which several threads share, or, with circumcentre, one after the other, the worst first, as in Aftosmis 1999</source>
        <translation>Dreiecke mit kleinen Winkeln bekommen ihre Punkte in Runden, die sich mehrere Threads teilen, oder, mit dem Umkreismittelpunkt, nacheinander, das schlechteste zuerst, wie in Aftosmis 1999</translation>
    </message>
    <message>
        <source>order = worst first is the order of Aftosmis 1999: use it with insertion = circumcentre</source>
        <translation>order = worst first ist die Reihenfolge von Aftosmis 1999: mit insertion = circumcentre benutzen</translation>
    </message>
    <message>
        <source>rounds</source>
        <translation>Runden</translation>
    </message>
    <message>
        <source>worst first</source>
        <translation>das schlechteste zuerst</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Analysis: {}</source>
        <translation>Analyse: {}</translation>
    </message>
    <message>
        <source>The error is below the target.</source>
        <translation>Der Fehler ist kleiner als das Ziel.</translation>
    </message>
    <message>
        <source>A finer mesh would have more unknowns than allowed.</source>
        <translation>Ein feineres Netz hätte mehr Unbekannte als erlaubt.</translation>
    </message>
    <message>
        <source>All steps are done; the error is above the target.</source>
        <translation>Alle Schritte sind getan; der Fehler ist größer als das Ziel.</translation>
    </message>
    <message>
        <source>The error does not get lower any more.</source>
        <translation>Der Fehler wird nicht mehr kleiner.</translation>
    </message>
    <message>
        <source>Cancelled; the last good step stays.</source>
        <translation>Abgebrochen; der letzte gute Schritt bleibt.</translation>
    </message>
    <message>
        <source>Solve the analysis once more for its results.</source>
        <translation>Die Analyse noch einmal lösen, dann sind ihre Ergebnisse da.</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relativ</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Whole elements</source>
        <translation>Ganze Elemente</translation>
    </message>
    <message>
        <source>Cut the mesh open by a plane</source>
        <translation>Das Netz mit einer Ebene aufschneiden</translation>
    </message>
    <message>
        <source>Leave elements whole: those whose middle is not cut off</source>
        <translation>Elemente ganz lassen: die, deren Mitte nicht abgeschnitten ist</translation>
    </message>
    <message>
        <source>Picked</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>Direction across which the mesh is cut</source>
        <translation>Richtung, quer zu der das Netz geschnitten wird</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Show the other half</source>
        <translation>Die andere Hälfte zeigen</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Then click on the mesh: the plane is parallel to its surface there</source>
        <translation>Danach auf das Netz klicken: die Ebene ist parallel zu seiner Oberfläche dort</translation>
    </message>
    <message>
        <source>Where the plane is: its coordinate, or its distance from the picked place</source>
        <translation>Wo die Ebene ist: ihre Koordinate, oder ihr Abstand von der gewählten Stelle</translation>
    </message>
    <message>
        <source>Facets where surfaces are not known</source>
        <translation>Facetten, wo Flächen unbekannt sind</translation>
    </message>
    <message>
        <source>A single face that is not known turns all faces into planar facets; off: the mesh is refused then</source>
        <translation>Eine einzige unbekannte Fläche macht alle Flächen zu ebenen Facetten; aus: dann wird das Netz abgelehnt</translation>
    </message>
    <message>
        <source>Adapt</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>CalculiX solves</source>
        <translation>CalculiX löst</translation>
    </message>
    <message>
        <source>Estimated relative error of the strains at which the work ends</source>
        <translation>Geschätzter relativer Fehler der Dehnungen, bei dem die Arbeit endet</translation>
    </message>
    <message>
        <source>Mesh and solid are within {length} of each other, measured at points; {length2} are allowed. Its volume is {volume}, that of the mesh {volume2}.</source>
        <translation>Netz und Festkörper sind höchstens {length} voneinander entfernt, an Punkten gemessen; {length2} sind erlaubt. Sein Volumen ist {volume}, das des Netzes {volume2}.</translation>
    </message>
    <message>
        <source>Most meshes that are made</source>
        <translation>Größte Zahl der Netze</translation>
    </message>
    <message>
        <source>Most unknowns</source>
        <translation>Höchstzahl der Unbekannten</translation>
    </message>
    <message>
        <source>No mesh is made that is expected to have more unknowns</source>
        <translation>Kein Netz wird erzeugt, das voraussichtlich mehr Unbekannte hat</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot intersect the faces ({text})</source>
        <translation>OpenCASCADE kann die Flächen nicht schneiden ({text})</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Target of the error</source>
        <translation>Ziel des Fehlers</translation>
    </message>
    <message>
        <source>The solid has 1 face on an exact surface.</source>
        <translation>Der Festkörper hat 1 Fläche auf einer exakten Fläche.</translation>
    </message>
    <message>
        <source>The solid has 1 planar facet: {phrase}.</source>
        <translation>Der Festkörper hat 1 ebene Facette: {phrase}.</translation>
    </message>
    <message>
        <source>The solid has {count} faces on exact surfaces.</source>
        <translation>Der Festkörper hat {count} Flächen auf exakten Flächen.</translation>
    </message>
    <message>
        <source>The solid has {count} planar facets: {phrase}.</source>
        <translation>Der Festkörper hat {count} ebene Facetten: {phrase}.</translation>
    </message>
    <message>
        <source>no face of the CAD lies on the mesh</source>
        <translation>keine Fläche des CAD liegt auf dem Netz</translation>
    </message>
    <message>
        <source>no solid with exact surfaces: {phrase}</source>
        <translation>kein Festkörper mit exakten Flächen: {phrase}</translation>
    </message>
    <message>
        <source>the faces of the CAD on the mesh do not close</source>
        <translation>die Flächen des CAD auf dem Netz schließen nicht</translation>
    </message>
    <message>
        <source>the mesh does not know the CAD it was made of</source>
        <translation>das Netz kennt das CAD nicht, aus dem es entstand</translation>
    </message>
    <message>
        <source>the mesh is not closed, manifold and oriented: repair it first</source>
        <translation>das Netz ist nicht geschlossen, mannigfaltig und orientiert: reparieren Sie es zuerst</translation>
    </message>
    <message>
        <source>the solid is not valid by OpenCASCADE&apos;s check</source>
        <translation>der Festkörper ist nach OpenCASCADEs Prüfung nicht gültig</translation>
    </message>
    <message>
        <source>the solid is {length} from the mesh, and {length2} are allowed</source>
        <translation>der Festkörper ist {length} vom Netz entfernt, und {length2} sind erlaubt</translation>
    </message>
    <message>
        <source>the volume of the solid, {volume}, is not that of the mesh, {volume2}</source>
        <translation>das Volumen des Festkörpers, {volume}, ist nicht das des Netzes, {volume2}</translation>
    </message>
    <message>
        <source>waiting for the window</source>
        <translation>wartet auf das Fenster</translation>
    </message>
    <message>
        <source>{name} adaptation</source>
        <translation>{name} Anpassung</translation>
    </message>
    <message>
        <source>{name} holds no mesh: give an object with a mesh</source>
        <translation>{name} enthält kein Netz: geben Sie ein Objekt mit einem Netz an</translation>
    </message>
    <message>
        <source>{name} is out of date: update it first</source>
        <translation>{name} ist nicht aktuell: aktualisieren Sie es zuerst</translation>
    </message>
    <message>
        <source>{name} solid</source>
        <translation>{name} Festkörper</translation>
    </message>
    <message>
        <source>{phrase}, and facets make no solid: {phrase2}</source>
        <translation>{phrase}, und Facetten ergeben keinen Festkörper: {phrase2}</translation>
    </message>
    <message>
        <source>{phrase}, and {count} triangles are too many facets: simplify the mesh to at most {count2}</source>
        <translation>{phrase}, und {count} Dreiecke sind zu viele Facetten: vereinfachen Sie das Netz auf höchstens {count2}</translation>
    </message>
    <message>
        <source>air of 20 °C</source>
        <translation>Luft von 20 °C</translation>
    </message>
    <message>
        <source>water of 20 °C</source>
        <translation>Wasser von 20 °C</translation>
    </message>
    <message>
        <source>First height for a y+</source>
        <translation>Erste Höhe für ein y+</translation>
    </message>
    <message>
        <source>Use this height</source>
        <translation>Diese Höhe verwenden</translation>
    </message>
    <message>
        <source>Of the free flow, or the mean one in a duct</source>
        <translation>Der freien Strömung oder die mittlere in einem Kanal</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Of the wall along the flow; of a duct its diameter</source>
        <translation>Der Wand längs der Strömung; eines Kanals sein Durchmesser</translation>
    </message>
    <message>
        <source>Fluid</source>
        <translation>Fluid</translation>
    </message>
    <message>
        <source>y+</source>
        <translation>y+</translation>
    </message>
    <message>
        <source>Of the centre of the first cell: 1 where the solver resolves the layer at the wall, 30 and more with wall functions</source>
        <translation>Der Mitte der ersten Zelle: 1, wo der Löser die Grenzschicht auflöst, 30 und mehr mit Wandfunktionen</translation>
    </message>
    <message>
        <source>{0}, as on a flat plate with a Reynolds number of {1}. Check the y+ that the solver finds.</source>
        <translation>{0}, wie an einer ebenen Platte mit einer Reynolds-Zahl von {1}. Prüfen Sie das y+, das der Löser findet.</translation>
    </message>
    <message>
        <source>Add a patch to the walls ...</source>
        <translation>Ein Patch zu den Wänden ...</translation>
    </message>
    <message>
        <source>Patches of this mesh, and of other meshes of the part</source>
        <translation>Patches dieses Netzes und anderer Netze des Teils</translation>
    </message>
    <message>
        <source>Counting cells ...</source>
        <translation>Zellen werden gezählt ...</translation>
    </message>
    <message>
        <source>{} cells</source>
        <translation>{} Zellen</translation>
    </message>
    <message>
        <source>About {} cells</source>
        <translation>Etwa {} Zellen</translation>
    </message>
    <message>
        <source>More than {} cells</source>
        <translation>Mehr als {} Zellen</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message>
        <source>By how much longer edges of tetrahedra get for each length of distance from the walls: 0.1 is slow, 0.8 is fast</source>
        <translation>Um wie viel länger Kanten von Tetraedern je Länge des Abstands von den Wänden werden: 0.1 ist langsam, 0.8 schnell</translation>
    </message>
    <message>
        <source>Coordinate of the plane of symmetry</source>
        <translation>Koordinate der Symmetrieebene</translation>
    </message>
    <message>
        <source>Distance in sizes</source>
        <translation>Abstand in Größen</translation>
    </message>
    <message>
        <source>Edges far away</source>
        <translation>Kanten weit weg</translation>
    </message>
    <message>
        <source>Faces of the part that get layers; none named: all. Layers end in the faces beside them, which must be planes</source>
        <translation>Flächen des Teils, die Schichten bekommen; keine genannt: alle. Schichten enden in den Flächen daneben, die eben sein müssen</translation>
    </message>
    <message>
        <source>Far field</source>
        <translation>Fernfeld</translation>
    </message>
    <message>
        <source>First height</source>
        <translation>Erste Höhe</translation>
    </message>
    <message>
        <source>Growth inside</source>
        <translation>Wachstum innen</translation>
    </message>
    <message>
        <source>Growth of layers</source>
        <translation>Wachstum der Schichten</translation>
    </message>
    <message>
        <source>Height of the layer on the wall</source>
        <translation>Höhe der Schicht an der Wand</translation>
    </message>
    <message>
        <source>How many times as high each layer is as the one before it</source>
        <translation>Wievielmal so hoch jede Schicht ist wie die vorige</translation>
    </message>
    <message>
        <source>How many times the largest dimension of the part the far field is away from it</source>
        <translation>Wie viele größte Abmessungen des Teils das Fernfeld von ihm entfernt ist</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Longest edges of triangles on the far field; unless given, a fifth of its distance</source>
        <translation>Längste Kanten von Dreiecken auf dem Fernfeld; wenn nicht angegeben, ein Fünftel seines Abstands</translation>
    </message>
    <message>
        <source>Number of layers of prisms on the walls</source>
        <translation>Anzahl der Schichten von Prismen an den Wänden</translation>
    </message>
    <message>
        <source>Plane at</source>
        <translation>Ebene bei</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>The first height for a y+ needs a speed and a length above 0</source>
        <translation>Die erste Höhe für ein y+ braucht eine Geschwindigkeit und eine Länge über 0</translation>
    </message>
    <message>
        <source>The half-space of the fluid, whose plane is one of symmetry</source>
        <translation>Der Halbraum des Fluids, dessen Ebene eine Symmetrieebene ist</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Where the fluid is: the part itself, or the space around it in a box or a sphere</source>
        <translation>Wo das Fluid ist: im Teil selbst oder im Raum darum in einem Quader oder einer Kugel</translation>
    </message>
    <message>
        <source>a wall names {value}, but {name} does not hold that: select it again in the 3D view</source>
        <translation>eine Wand nennt {value}, aber {name} enthält das nicht: wählen Sie es in der 3D-Ansicht neu</translation>
    </message>
    <message>
        <source>a wall names {value}, but {name} has faces Face1 to {face}: take it out or name another one</source>
        <translation>eine Wand nennt {value}, aber {name} hat die Flächen Face1 bis {face}: nehmen Sie sie heraus oder nennen Sie eine andere</translation>
    </message>
    <message>
        <source>all faces</source>
        <translation>alle Flächen</translation>
    </message>
    <message>
        <source>around, box</source>
        <translation>außen, Quader</translation>
    </message>
    <message>
        <source>around, sphere</source>
        <translation>außen, Kugel</translation>
    </message>
    <message>
        <source>by distance</source>
        <translation>nach Abstand</translation>
    </message>
    <message>
        <source>layers cover {number} % of the walls, and {number2} % with the height that was asked for</source>
        <translation>Schichten bedecken {number} % der Wände, {number2} % in der verlangten Höhe</translation>
    </message>
    <message>
        <source>layers do not cover all of 1 wall: {list}</source>
        <translation>Schichten bedecken 1 Wand nicht ganz: {list}</translation>
    </message>
    <message>
        <source>layers do not cover all of {count} walls: {list}</source>
        <translation>Schichten bedecken {count} Wände nicht ganz: {list}</translation>
    </message>
    <message>
        <source>non-orthogonality up to {number}°</source>
        <translation>Nichtorthogonalität bis {number}°</translation>
    </message>
    <message>
        <source>x above</source>
        <translation>x darüber</translation>
    </message>
    <message>
        <source>x below</source>
        <translation>x darunter</translation>
    </message>
    <message>
        <source>y above</source>
        <translation>y darüber</translation>
    </message>
    <message>
        <source>y below</source>
        <translation>y darunter</translation>
    </message>
    <message>
        <source>z above</source>
        <translation>z darüber</translation>
    </message>
    <message>
        <source>z below</source>
        <translation>z darunter</translation>
    </message>
    <message>
        <source>{count} cells</source>
        <translation>{count} Zellen</translation>
    </message>
    <message>
        <source>{face} of the walls may be another face after the edit: choose the walls anew</source>
        <translation>{face} der Wände kann nach der Änderung eine andere Fläche sein: wählen Sie die Wände neu</translation>
    </message>
    <message>
        <source>{face} {number} %</source>
        <translation>{face} {number} %</translation>
    </message>
    <message>
        <source>{name} flow mesh</source>
        <translation>{name} Strömungsnetz</translation>
    </message>
    <message>
        <source>in the part</source>
        <translation>im Teil</translation>
    </message>
    <message>
        <source>no valid layers were found: give thinner ones, or a finer surface by max_edge</source>
        <translation>es wurden keine gültigen Schichten gefunden: geben Sie dünnere an oder eine feinere Oberfläche durch eine kürzere längste Kante</translation>
    </message>
    <message>
        <source>the surface of the solid is not closed, or touches itself along an edge: repair the solid</source>
        <translation>die Oberfläche des Körpers ist nicht geschlossen oder berührt sich an einer Kante selbst: reparieren Sie den Körper</translation>
    </message>
    <message>
        <source>{face} is not plane, but beside walls: layers cannot end in it; make it a wall, too</source>
        <translation>{face} ist nicht eben, liegt aber neben Wänden: Schichten können darin nicht enden; machen Sie sie auch zur Wand</translation>
    </message>
    <message>
        <source>{face}: nowhere on it do layers of {length} fit, not even a fifth as high, and end in the faces beside it: give fewer or thinner layers, a finer surface by local_sizes, or leave it out of walls</source>
        <translation>{face}: nirgends darauf passen Schichten von {length}, auch nicht ein Fünftel so hohe, die in den Flächen daneben enden: geben Sie weniger oder dünnere Schichten an, eine feinere Oberfläche durch lokale Größen, oder lassen Sie sie bei den Wänden weg</translation>
    </message>
    <message>
        <source>{face}: the layers are {length} thick, but the gap there is {length2} at most: give fewer or thinner layers</source>
        <translation>{face}: die Schichten sind {length} dick, aber der Spalt dort ist höchstens {length2}: geben Sie weniger oder dünnere Schichten an</translation>
    </message>
    <message>
        <source>{name} has {count} solids, not one: the fluid must be a single solid; unite several, or make one of the faces; for the flow around them give far_field</source>
        <translation>{name} hat {count} Körper statt eines: das Fluid muss ein einziger Körper sein; vereinigen Sie mehrere oder machen Sie einen aus den Flächen; für die Strömung um sie geben Sie ein Fernfeld an</translation>
    </message>
    <message>
        <source>Largest stretching</source>
        <translation>Größte Streckung</translation>
    </message>
    <message>
        <source>Longest length that a metric may want at a place, divided by the shortest</source>
        <translation>Größte Länge, die eine Metrik an einem Ort verlangen darf, geteilt durch die kleinste</translation>
    </message>
    <message>
        <source>Stretched triangles</source>
        <translation>Gestreckte Dreiecke</translation>
    </message>
    <message>
        <source>Triangles that are stretched along the direction in which the surface bends least, so that fewer keep the distance; the largest angle is bounded by 150 degrees then, instead of the smallest one</source>
        <translation>Dreiecke, die in der Richtung gestreckt sind, in der sich die Fläche am wenigsten krümmt, so dass weniger die Abweichung einhalten; begrenzt ist dann der größte Winkel auf 150 Grad statt des kleinsten</translation>
    </message>
    <message>
        <source>by curvature</source>
        <translation>nach der Krümmung</translation>
    </message>
    <message>
        <source>Click or drag over bars to highlight; heights are logarithmic.</source>
        <translation>Klick oder Ziehen über Balken hebt hervor; Höhen logarithmisch.</translation>
    </message>
    <message>
        <source>Write a page with pictures, figures, faces and places, as HTML or PDF</source>
        <translation>Eine Seite mit Bildern, Zahlen, Flächen und Stellen als HTML oder PDF schreiben</translation>
    </message>
    <message>
        <source>Written: {}</source>
        <translation>Geschrieben: {}</translation>
    </message>
    <message>
        <source>Bodies and faces</source>
        <translation>Körper und Flächen</translation>
    </message>
    <message>
        <source>Edges and corners</source>
        <translation>Kanten und Ecken</translation>
    </message>
    <message>
        <source>1: straight sides; from 2 on layers follow the CAD</source>
        <translation>1: gerade Seiten; ab 2 folgen die Schichten dem CAD</translation>
    </message>
    <message>
        <source>cases of OpenFOAM hold elements with straight sides, not of order {count}: make the mesh with order=1</source>
        <translation>Fälle von OpenFOAM haben Elemente mit geraden Seiten, nicht der Ordnung {count}: das Netz mit order=1 erzeugen</translation>
    </message>
    <message>
        <source>some elements are valid only with nodes amid their quadrilaterals, which FreeCAD&apos;s FEM meshes do not have: give a finer surface by max_edge, or order 1</source>
        <translation>einige Elemente sind nur mit Knoten mitten in ihren Vierecken gültig, die FreeCADs FEM-Netze nicht haben: mit max_edge eine feinere Oberfläche angeben, oder Ordnung 1</translation>
    </message>
    <message>
        <source>the mesh stands beside its part, as FreeCAD&apos;s FEM workbench looks for faces where the document has them, whatever the containers around the mesh: it solves rightly; to see mesh and results on the part, take the mesh and its analysis out of {name}</source>
        <translation>das Netz steht neben seinem Bauteil, da FreeCADs FEM-Arbeitsbereich Flächen dort sucht, wo das Dokument sie hat, was immer die Behälter um das Netz sind: gerechnet wird richtig; um Netz und Ergebnisse auf dem Bauteil zu sehen, nehmen Sie das Netz und seine Analyse aus {name} heraus</translation>
    </message>
    <message>
        <source>edges and faces below {length} are not told apart: with all of them the mesh had {count} triangles or more, and the max. deviation asks for less than a twentieth of these. Ask for a smaller one, or for edge lengths, to keep them</source>
        <translation>Kanten und Flächen unter {length} werden nicht unterschieden: mit allen hätte das Netz {count} Dreiecke oder mehr, und die max. Abweichung verlangt weniger als ein Zwanzigstel davon. Um sie zu behalten, eine kleinere oder Kantenlängen verlangen</translation>
    </message>
    <message>
        <source>{0} passed</source>
        <translation>{0} vergangen</translation>
    </message>
    <message>
        <source>{0} passed, about {1} left</source>
        <translation>{0} vergangen, noch etwa {1}</translation>
    </message>
    <message>
        <source>{0}: {1}; a point inside, for snappyHexMesh: {2}</source>
        <translation>{0}: {1}; ein Punkt im Innern, für snappyHexMesh: {2}</translation>
    </message>
</context>
<context>
    <name>MeshQualityFilePreferences</name>
    <message>
        <source>Export and import</source>
        <translation>Export und Import</translation>
    </message>
    <message>
        <source>Quality meshes of File - Export</source>
        <translation>Qualitätsnetze von Datei - Exportieren</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>Max. deviation from the shape, relative to its size: 0.01, 0.003, 0.001 or 0.0003. In files for solvers it is that of the mesh before it is curved: 0.03, 0.01, 0.005 or 0.001</source>
        <translation>Max. Abweichung von der Form, relativ zu ihrer Größe: 0,01, 0,003, 0,001 oder 0,0003. In Dateien für Löser gilt sie für das Netz, bevor es gekrümmt wird: 0,03, 0,01, 0,005 oder 0,001</translation>
    </message>
    <message>
        <source>Coarse</source>
        <translation>Grob</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>Very fine</source>
        <translation>Sehr fein</translation>
    </message>
    <message>
        <source>Files for solvers</source>
        <translation>Dateien für Löser</translation>
    </message>
    <message>
        <source>What files for solvers get of a shape with solids</source>
        <translation>Was Dateien für Löser von einer Form mit Körpern erhalten</translation>
    </message>
    <message>
        <source>Tetrahedra that fill solids</source>
        <translation>Tetraeder, die Körper füllen</translation>
    </message>
    <message>
        <source>Triangles on the surface</source>
        <translation>Dreiecke auf der Oberfläche</translation>
    </message>
    <message>
        <source>Element order</source>
        <translation>Ordnung der Elemente</translation>
    </message>
    <message>
        <source>Of elements in files for solvers: 1 has straight sides, 2 is what most FEM programs want; formats that hold lower ones only get their highest</source>
        <translation>Der Elemente in Dateien für Löser: 1 hat gerade Seiten, 2 ist, was die meisten FEM-Programme wollen; Formate, die nur niedrigere halten, erhalten ihre höchste</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>The unit of the numbers in files, in File - Export and in File - Import of meshes for solvers; solvers mostly take metres, files for printing mm</source>
        <translation>Die Einheit der Zahlen in Dateien, bei Datei - Exportieren und beim Importieren von Netzen für Löser; Löser nehmen meist Meter, Dateien für den Druck mm</translation>
    </message>
    <message>
        <source>Max. deviation (0: by fineness)</source>
        <translation>Max. Abweichung (0: nach Feinheit)</translation>
    </message>
    <message>
        <source>As a length, in place of the fineness. The smallest angle is that of new meshes, on the page General</source>
        <translation>Als Länge anstelle der Feinheit. Der kleinste Winkel ist der neuer Netze auf der Seite Allgemein</translation>
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
        <source>Updates</source>
        <translation>Aktualisierung</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> Dreiecken</translation>
    </message>
    <message>
        <source>Do not update new meshes automatically above</source>
        <translation>Neue Netze nicht von selbst aktualisieren ab</translation>
    </message>
    <message>
        <source>Larger meshes wait until Update mesh is chosen</source>
        <translation>Größere Netze warten, bis Netz aktualisieren gewählt wird</translation>
    </message>
    <message>
        <source>Above 30 degrees many more triangles are needed</source>
        <translation>Über 30 Grad werden viel mehr Dreiecke gebraucht</translation>
    </message>
    <message>
        <source>Start panels with the values used last</source>
        <translation>Aufgabenbereiche mit den zuletzt benutzten Werten beginnen</translation>
    </message>
    <message>
        <source>Angles, relative values and choices are remembered, lengths and local sizes are not. If unchecked, panels start with medium fineness and the angle above</source>
        <translation>Winkel, relative Werte und Auswahlen werden gemerkt, Längen und lokale Größen nicht. Sonst beginnen Aufgabenbereiche mit mittlerer Feinheit und dem Winkel oben</translation>
    </message>
    <message>
        <source>Update meshes in the background</source>
        <translation>Netze im Hintergrund aktualisieren</translation>
    </message>
    <message>
        <source>If unchecked, FreeCAD waits until they are computed</source>
        <translation>Sonst wartet FreeCAD, bis sie berechnet sind</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Threads that work at a time</source>
        <translation>Threads, die zugleich arbeiten</translation>
    </message>
    <message>
        <source>Results do not depend on it. Takes effect when FreeCAD is started again</source>
        <translation>Ergebnisse hängen nicht davon ab. Gilt, sobald FreeCAD neu gestartet ist</translation>
    </message>
    <message>
        <source>One for each core</source>
        <translation>Einer je Kern</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Adapt</name>
    <message>
        <source>Adapt mesh...</source>
        <translation>Netz anpassen...</translation>
    </message>
    <message>
        <source>Refine the FEM mesh of the selected analysis where the error of its solution is, step by step, solved by CalculiX
Select an analysis with a FEM mesh of MeshQuality, or that mesh, first.</source>
        <translation>Das FEM-Netz der gewählten Analyse dort verfeinern, wo der Fehler der Lösung ist, Schritt für Schritt, gelöst von CalculiX
Zuerst eine Analyse mit einem FEM-Netz von MeshQuality wählen, oder dieses Netz.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Analyse</name>
    <message>
        <source>Analyse quality...</source>
        <translation>Netzqualität untersuchen...</translation>
    </message>
    <message>
        <source>Colour the selected mesh by its quality and find its worst elements
Select one mesh or FEM mesh first.</source>
        <translation>Färbt das gewählte Netz nach seiner Qualität und findet die schlechtesten Elemente
Zuerst ein Netz oder FEM-Netz wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Boolean</name>
    <message>
        <source>Mesh Boolean...</source>
        <translation>Boolesche Netzoperation...</translation>
    </message>
    <message>
        <source>Unite, intersect or subtract the selected meshes and shapes, in the order of selection
Select two or more meshes or shapes first.</source>
        <translation>Ausgewählte Netze und Formen vereinigen, schneiden oder abziehen, in der Reihenfolge der Auswahl
Zuerst zwei oder mehr Netze oder Formen wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_CamMesh</name>
    <message>
        <source>CAM mesh...</source>
        <translation>CAM-Netz...</translation>
    </message>
    <message>
        <source>Mesh the selected solids for machining, never inside of them, so that no tool cuts into the part, or never outside
Select one or more solids or closed meshes first.</source>
        <translation>Die gewählten Körper zum Fräsen vernetzen, nie in ihnen, so dass kein Werkzeug in das Teil schneidet, oder nie außerhalb
Zuerst einen oder mehrere Körper oder geschlossene Netze wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_CfdSurface</name>
    <message>
        <source>CFD surface</source>
        <translation>CFD-Oberfläche</translation>
    </message>
    <message>
        <source>Make a shape of the selected closed mesh, one face a patch, of which CfdOF takes the triangles
Select one closed mesh first.</source>
        <translation>Macht aus dem gewählten geschlossenen Netz eine Form mit einer Fläche je Patch, von der CfdOF die Dreiecke nimmt
Zuerst ein geschlossenes Netz wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Cure</name>
    <message>
        <source>Certify and cure...</source>
        <translation>Prüfen und heilen...</translation>
    </message>
    <message>
        <source>Prove which elements of the selected FEM mesh are valid, and make those valid that are not, on its part
Select one FEM mesh first, and its part where it does not name it.</source>
        <translation>Beweisen, welche Elemente des ausgewählten FEM-Netzes gültig sind, und die übrigen auf dem Teil gültig machen
Zuerst ein FEM-Netz wählen, und sein Teil, wo es dieses nicht nennt.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Curve</name>
    <message>
        <source>Curved mesh...</source>
        <translation>Gekrümmtes Netz...</translation>
    </message>
    <message>
        <source>Mesh the selected shapes with curved elements, each proven valid
Select one or more shapes first.</source>
        <translation>Ausgewählte Formen mit gekrümmten Elementen vernetzen, jedes nachweislich gültig
Zuerst eine oder mehrere Formen wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Deviation</name>
    <message>
        <source>Deviation...</source>
        <translation>Abweichung...</translation>
    </message>
    <message>
        <source>Colour the selected scan, a mesh or points, by its signed distance from the selected part, aligned before if asked
Select a mesh or points, and a part, first.</source>
        <translation>Den gewählten Scan, ein Netz oder Punkte, nach dem Abstand vom gewählten Teil färben, mit Vorzeichen, auf Wunsch vorher ausgerichtet
Zuerst ein Netz oder Punkte und ein Teil wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Examples</name>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Open two new documents: a pipe tee to mesh, and a scan with a bump and holes to inspect and repair</source>
        <translation>Zwei neue Dokumente öffnen: ein T-Stück zum Vernetzen, und einen Scan mit einer Beule und Löchern zum Prüfen und Reparieren</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Export</name>
    <message>
        <source>Export mesh...</source>
        <translation>Netz exportieren...</translation>
    </message>
    <message>
        <source>Write the selected mesh into a file for a solver or a printer, with the names of its patches
Select one mesh or FEM mesh first.</source>
        <translation>Schreibt das gewählte Netz mit den Namen seiner Patches in eine Datei für einen Löser oder Drucker
Zuerst ein Netz oder FEM-Netz wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_FemMesh</name>
    <message>
        <source>FEM mesh...</source>
        <translation>FEM-Netz...</translation>
    </message>
    <message>
        <source>Mesh the selected shapes for FreeCAD&apos;s FEM workbench, in the active analysis
Select one or more shapes first.</source>
        <translation>Ausgewählte Formen für FreeCADs FEM-Arbeitsbereich vernetzen, in der aktiven Analyse
Zuerst eine oder mehrere Formen wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_FirstSteps</name>
    <message>
        <source>A first part in five minutes, and all other pages of the documentation</source>
        <translation>Ein erstes Teil in fünf Minuten und alle anderen Seiten der Dokumentation (englisch)</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
</context>
<context>
    <name>MeshQuality_FlowCase</name>
    <message>
        <source>OpenFOAM case...</source>
        <translation>OpenFOAM-Fall...</translation>
    </message>
    <message>
        <source>Write a folder in which OpenFOAM meshes the space inside of the selected mesh, or around it, or finds the cells of a flow mesh
Select one mesh first.</source>
        <translation>Einen Ordner schreiben, in dem OpenFOAM den Raum im gewählten Netz oder um es herum vernetzt oder die Zellen eines Strömungsnetzes findet
Wählen Sie zuerst ein Netz.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_FlowMesh</name>
    <message>
        <source>Fill the selected solid, or the space around it, for flow solvers, with layers of prisms on walls
Select one or more solids first, or faces of one that are walls.</source>
        <translation>Den gewählten Körper oder den Raum um ihn für Strömungslöser füllen, mit Schichten von Prismen an Wänden
Wählen Sie zuerst einen oder mehrere Körper oder Flächen eines Körpers, die Wände sind.</translation>
    </message>
    <message>
        <source>Flow mesh...</source>
        <translation>Strömungsnetz...</translation>
    </message>
</context>
<context>
    <name>MeshQuality_GetBinary</name>
    <message>
        <source>How to get the binary file without which MeshQuality cannot compute</source>
        <translation>Wie man die Binärdatei bekommt, ohne die MeshQuality nicht rechnen kann</translation>
    </message>
    <message>
        <source>Missing binary...</source>
        <translation>Fehlende Binärdatei...</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Hollow</name>
    <message>
        <source>Hollow...</source>
        <translation>Aushöhlen...</translation>
    </message>
    <message>
        <source>Leave a wall of the selected solids, for printing and casting; selected faces become openings
Select one or more solids or closed meshes first, or faces of one solid.</source>
        <translation>Von den gewählten Körpern eine Wand übrig lassen, zum Drucken und Gießen; gewählte Flächen werden Öffnungen
Zuerst einen oder mehrere Körper oder geschlossene Netze wählen, oder Flächen eines Körpers.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Improve</name>
    <message>
        <source>Improve mesh...</source>
        <translation>Netz verbessern...</translation>
    </message>
    <message>
        <source>Improve the triangles of the selected meshes on their surface; sharp edges stay
Select one or more meshes first.</source>
        <translation>Dreiecke der ausgewählten Netze auf ihrer Oberfläche verbessern; scharfe Kanten bleiben
Zuerst ein Netz oder mehrere Netze wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Inspect</name>
    <message>
        <source>Inspection...</source>
        <translation>Prüfung von Körpern...</translation>
    </message>
    <message>
        <source>Measure walls, clearances, draft or closed voids of the selected solids again after each edit, against a limit
Select one or more solids or closed meshes first.</source>
        <translation>Wände, Abstände, Entformungsschräge oder geschlossene Hohlräume der gewählten Körper nach jeder Änderung neu messen, gegen einen Grenzwert
Zuerst einen oder mehrere Körper oder geschlossene Netze wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Offset</name>
    <message>
        <source>Offset...</source>
        <translation>Versatz...</translation>
    </message>
    <message>
        <source>Grow or shrink the selected solids by a distance; of shapes and of closed meshes
Select one or more solids or closed meshes first.</source>
        <translation>Die gewählten Körper um einen Abstand wachsen oder schrumpfen lassen; von Formen und geschlossenen Netzen
Zuerst einen oder mehrere Körper oder geschlossene Netze wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Patches</name>
    <message>
        <source>Patches...</source>
        <translation>Patches...</translation>
    </message>
    <message>
        <source>Name groups of faces of the selected mesh, such as inlet and wall, for files
Select one mesh of a shape first.</source>
        <translation>Benennt Gruppen von Flächen des gewählten Netzes, etwa Einlass und Wand, für Dateien
Zuerst ein Netz einer Form wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Quick</name>
    <message>
        <source>Quick mesh</source>
        <translation>Schnelles Netz</translation>
    </message>
    <message>
        <source>Mesh the selected shape at once, with the values used last, and show its quality in colour
Select one shape first.</source>
        <translation>Vernetzt die gewählte Form sofort mit den zuletzt benutzten Werten und zeigt ihre Qualität farbig
Zuerst eine Form wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Repair</name>
    <message>
        <source>Repair mesh...</source>
        <translation>Netz reparieren...</translation>
    </message>
    <message>
        <source>List the faults of the selected mesh, show where they are, and make a closed mesh without them
Select one mesh first.</source>
        <translation>Die Fehler des gewählten Netzes auflisten und zeigen und ein geschlossenes Netz ohne sie erzeugen
Zuerst ein Netz wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_SaveReport</name>
    <message>
        <source>Save report...</source>
        <translation>Bericht speichern...</translation>
    </message>
    <message>
        <source>Write a page with pictures of the selected mesh or inspection: what was requested and found, by face, and where it is poor
Select one mesh or FEM mesh first.</source>
        <translation>Eine Seite mit Bildern des gewählten Netzes oder der Prüfung schreiben: was gefordert war und gefunden wurde, nach Fläche, und wo es schlecht ist
Zuerst ein Netz oder FEM-Netz wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Simplify</name>
    <message>
        <source>Fewer triangles for the selected meshes, within a distance that is proven; sharp edges stay
Select one or more meshes first.</source>
        <translation>Weniger Dreiecke für die gewählten Netze, in bewiesenem Abstand; scharfe Kanten bleiben
Zuerst ein Netz oder mehrere Netze wählen.</translation>
    </message>
    <message>
        <source>Simplify...</source>
        <translation>Vereinfachen...</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Thickness</name>
    <message>
        <source>Wall thickness...</source>
        <translation>Wanddicke...</translation>
    </message>
    <message>
        <source>Colour the selected closed mesh by the thickness of its walls and find the thinnest
Select one closed mesh first.</source>
        <translation>Das gewählte geschlossene Netz nach der Dicke seiner Wände färben und die dünnsten finden
Zuerst ein geschlossenes Netz wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_ToSolid</name>
    <message>
        <source>Make a CAD solid of the selected closed mesh, with the exact surfaces of the shapes that it was made of
Select one closed mesh first.</source>
        <translation>Aus dem gewählten geschlossenen Netz einen CAD-Festkörper mit den exakten Flächen der Formen machen, aus denen es entstand
Wählen Sie zuerst ein geschlossenes Netz.</translation>
    </message>
    <message>
        <source>To solid...</source>
        <translation>In Festkörper umwandeln...</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Triangulate</name>
    <message>
        <source>Quality mesh...</source>
        <translation>Qualitätsnetz...</translation>
    </message>
    <message>
        <source>Mesh the selected shapes with a guaranteed smallest angle
Select one or more shapes first.</source>
        <translation>Vernetzt die gewählten Formen mit garantiertem kleinsten Winkel
Zuerst eine oder mehrere Formen wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Update</name>
    <message>
        <source>Update mesh</source>
        <translation>Netz aktualisieren</translation>
    </message>
    <message>
        <source>Compute the selected meshes again where a source or an option has changed
Select one or more meshes of MeshQuality first.</source>
        <translation>Ausgewählte Netze neu berechnen, wo sich eine Quelle oder Option geändert hat
Zuerst ein Netz oder mehrere Netze von MeshQuality wählen.</translation>
    </message>
</context>
<context>
    <name>MeshQuality_Wrap</name>
    <message>
        <source>Wrap...</source>
        <translation>Umhüllen...</translation>
    </message>
    <message>
        <source>Close the outer surface of the selected objects, which may overlap, be open or have gaps, for flow simulations
Select two or more objects first.</source>
        <translation>Die äußere Oberfläche der gewählten Objekte schließen, die sich überlappen, offen sein oder Lücken haben dürfen, für Strömungsrechnungen
Zuerst zwei oder mehr Objekte wählen.</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Mesh Quality</source>
        <translation>Netzqualität</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Vernetzen</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Meshes of CAD shapes with guaranteed quality</source>
        <translation>Netze von CAD-Formen mit garantierter Qualität</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>Hand over</source>
        <translation>Weitergeben</translation>
    </message>
    <message>
        <source>Mesh Quality: inspect and repair</source>
        <translation>Netzqualität: prüfen und reparieren</translation>
    </message>
    <message>
        <source>Mesh Quality: print and hand over</source>
        <translation>Netzqualität: drucken und weitergeben</translation>
    </message>
</context>
</TS>
