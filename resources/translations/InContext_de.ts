<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>InContext</name>
    <message>
        <source>, {0:.2f} for the stock</source>
        <translation>, {0:.2f} für das Material</translation>
    </message>
    <message>
        <source>"makes" says neither plates nor print</source>
        <translation>"makes" nennt weder plates noch print</translation>
    </message>
    <message>
        <source>210, 21 cm, 3/4 in</source>
        <translation>210, 21 cm, 3/4 in</translation>
    </message>
    <message>
        <source>3, 0.5 cm, 1/8 in</source>
        <translation>3, 0.5 cm, 1/8 in</translation>
    </message>
    <message>
        <source>90, 9 cm, 3/4 in</source>
        <translation>90, 9 cm, 3/4 in</translation>
    </message>
    <message>
        <source>A bookshelf drawn over a photo of a desk, all the way to its plates</source>
        <translation>Ein Bücherregal, über das Foto eines Tisches gezeichnet, bis hin zu den Platten</translation>
    </message>
    <message>
        <source>A lens of {0:.0f} mm (equivalent), {1:.0f} mm above the ground; heights are good to {2:.1f} %.</source>
        <translation>Ein Objektiv von {0:.0f} mm (Kleinbild), {1:.0f} mm über dem Boden; Höhen stimmen auf {2:.1f} %.</translation>
    </message>
    <message>
        <source>A photo that was not cropped looks towards its middle.</source>
        <translation>Ein Foto, das nicht beschnitten ist, blickt auf seine Mitte.</translation>
    </message>
    <message>
        <source>A print whose wall lies outside what is drawn</source>
        <translation>Ein Druck, dessen Wand außerhalb der Zeichnung liegt</translation>
    </message>
    <message>
        <source>A print; a marker in the photo gives camera and size</source>
        <translation>Ein Druck; eine Marke im Foto gibt Kamera und Größe</translation>
    </message>
    <message>
        <source>A print; traced tiles give the size</source>
        <translation>Ein Druck; nachgezeichnete Fliesen geben die Größe</translation>
    </message>
    <message>
        <source>A4 sheet</source>
        <translation>Blatt A4</translation>
    </message>
    <message>
        <source>A5 sheet</source>
        <translation>Blatt A5</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>All vertices lie on one line: draw edges in at least two directions.</source>
        <translation>Alle Punkte liegen auf einer Linie: bitte Kanten in mindestens zwei Richtungen zeichnen.</translation>
    </message>
    <message>
        <source>Angle between the edges {0} and {1}</source>
        <translation>Winkel zwischen den Kanten {0} und {1}</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Angaben</translation>
    </message>
    <message>
        <source>As the rectangle, with four equal sides</source>
        <translation>Wie das Rechteck, mit vier gleichen Seiten</translation>
    </message>
    <message>
        <source>Bank card</source>
        <translation>Bankkarte</translation>
    </message>
    <message>
        <source>Between two plates</source>
        <translation>Zwischen zwei Platten</translation>
    </message>
    <message>
        <source>Bookshelf</source>
        <translation>Bücherregal</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>By the traced lines</source>
        <translation>Nach den nachgezeichneten Linien</translation>
    </message>
    <message>
        <source>Camera from a rectangle</source>
        <translation>Kamera aus einem Rechteck</translation>
    </message>
    <message>
        <source>Camera of the photo</source>
        <translation>Kamera des Fotos</translation>
    </message>
    <message>
        <source>Camera of the photo...</source>
        <translation>Kamera des Fotos...</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cardboard for a laser, over a photo of a room</source>
        <translation>Pappe für den Laser, über dem Foto eines Zimmers</translation>
    </message>
    <message>
        <source>Change circle</source>
        <translation>Kreis ändern</translation>
    </message>
    <message>
        <source>Change construction</source>
        <translation>Hilfsgeometrie umschalten</translation>
    </message>
    <message>
        <source>Check fit</source>
        <translation>Passung prüfen</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Fix or free angle</source>
        <translation>Winkel festlegen oder freigeben</translation>
    </message>
    <message>
        <source>Fix the angle between two edges that meet, selected in 3D, to type it anew among the model's dimensions; a fixed one follows the drawing again</source>
        <translation>Den Winkel zwischen zwei in 3D ausgewählten Kanten, die sich treffen, festlegen, um ihn unter den Maßen des Modells neu einzugeben; ein festgelegter folgt wieder der Zeichnung</translation>
    </message>
    <message>
        <source>The angles that are said of this model's corners: two edges and the degrees between them</source>
        <translation>Die Winkel, die für Ecken dieses Modells angegeben sind: zwei Kanten und die Grad zwischen ihnen</translation>
    </message>
    <message>
        <source>an angle of {0} degrees between {1} and {2} cannot hold beside what else is said</source>
        <translation>ein Winkel von {0} Grad zwischen {1} und {2} widerspricht dem, was sonst angegeben ist</translation>
    </message>
    <message>
        <source>angle {} {}</source>
        <translation>Winkel {} {}</translation>
    </message>
    <message>
        <source>between {} and {} degrees: edges at 0 or 180 degrees lie on one line</source>
        <translation>zwischen {} und {} Grad: Kanten bei 0 oder 180 Grad liegen auf einer Linie</translation>
    </message>
    <message>
        <source>the method {}, or freeing that angle</source>
        <translation>die Methode {} oder diesen Winkel freigeben</translation>
    </message>
    <message>
        <source>lengths of its edges, or diameters</source>
        <translation>Längen ihrer Kanten oder Durchmesser</translation>
    </message>
    <message>
        <source>no angle lies between these: select two drawn edges that meet</source>
        <translation>zwischen diesen liegt kein Winkel: zwei gezeichnete Kanten auswählen, die sich treffen</translation>
    </message>
    <message>
        <source>only right angles stand in a sketch; others are said of the model</source>
        <translation>in einer Skizze stehen nur rechte Winkel; andere werden am Modell angegeben</translation>
    </message>
    <message>
        <source>say them anew</source>
        <translation>sie neu angeben</translation>
    </message>
    <message>
        <source>take one of the others away first</source>
        <translation>zuerst eine der anderen Angaben entfernen</translation>
    </message>
    <message>
        <source>the model's angles are no JSON</source>
        <translation>die Winkel des Modells sind kein JSON</translation>
    </message>
    <message>
        <source>the papers' methods know no angle between {0} and {1} but a right one</source>
        <translation>die Methoden der Veröffentlichungen kennen zwischen {0} und {1} nur einen rechten Winkel</translation>
    </message>
    <message>
        <source>the side of a surface of revolution takes no angles</source>
        <translation>die Seite einer Rotationsfläche nimmt keine Winkel an</translation>
    </message>
    <message>
        <source>{}: not a length, the old one stays.</source>
        <translation>{}: keine Länge, die alte bleibt.</translation>
    </message>
    <message>
        <source>Choose a folder for the fit test</source>
        <translation>Ordner für den Passungstest wählen</translation>
    </message>
    <message>
        <source>Choose a folder for the plates</source>
        <translation>Ordner für die Platten wählen</translation>
    </message>
    <message>
        <source>Choose a folder for the print</source>
        <translation>Ordner für den Druck wählen</translation>
    </message>
    <message>
        <source>Choose a photo</source>
        <translation>Foto wählen</translation>
    </message>
    <message>
        <source>Choose a sketch</source>
        <translation>Skizze wählen</translation>
    </message>
    <message>
        <source>Choose the photo of the place where the new object will live; it is kept inside the document</source>
        <translation>Das Foto des Ortes wählen, an dem das neue Objekt stehen wird; es wird im Dokument gespeichert</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Choosing one sets the values that suit it; they can be edited all the same</source>
        <translation>Eine Wahl setzt die passenden Werte; sie können trotzdem geändert werden</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Clearance, overlap and missing millimetres to each thing traced on the photo</source>
        <translation>Abstand, Überschneidung und fehlende Millimeter zu jedem auf dem Foto nachgezeichneten Ding</translation>
    </message>
    <message>
        <source>Click a vertex that touches a face</source>
        <translation>Einen Punkt anklicken, der eine Fläche berührt</translation>
    </message>
    <message>
        <source>Click a vertex, then the middle of the face that it touches</source>
        <translation>Einen Punkt anklicken, dann die Mitte der Fläche, die er berührt</translation>
    </message>
    <message>
        <source>Click along the side, up to the edge of the top circle; Enter or right click ends</source>
        <translation>Entlang der Seite klicken, bis zum Rand des oberen Kreises; Enter oder Rechtsklick beendet</translation>
    </message>
    <message>
        <source>Click an angle near its corner, or inside a quadrilateral for all four</source>
        <translation>Einen Winkel nahe seiner Ecke anklicken, oder in ein Viereck für alle vier</translation>
    </message>
    <message>
        <source>Click an angle that is a right one, or inside a quadrilateral for all four</source>
        <translation>Einen rechten Winkel anklicken, oder in ein Viereck für alle vier</translation>
    </message>
    <message>
        <source>Click an edge or a circle and type its size: 210, 21 cm or 3/4 in</source>
        <translation>Kante oder Kreis anklicken und das Maß eingeben: 210, 21 cm oder 3/4 in</translation>
    </message>
    <message>
        <source>Click an edge or a circle and type its size (21 cm, 2*18 mm + 5); empty removes it</source>
        <translation>Kante oder Kreis anklicken, Maß eingeben (21 cm, 2*18 mm + 5); leer entfernt es</translation>
    </message>
    <message>
        <source>Click edges that are equally long, then Enter or right click</source>
        <translation>Gleich lange Kanten anklicken, dann Enter oder Rechtsklick</translation>
    </message>
    <message>
        <source>Click edges that are equally long, then press Enter</source>
        <translation>Gleich lange Kanten anklicken, dann Enter</translation>
    </message>
    <message>
        <source>Click edges that are parallel, then Enter or right click</source>
        <translation>Parallele Kanten anklicken, dann Enter oder Rechtsklick</translation>
    </message>
    <message>
        <source>Click edges that are parallel, then press Enter</source>
        <translation>Parallele Kanten anklicken, dann Enter</translation>
    </message>
    <message>
        <source>Click in the middle of a face and type how thick its plate is</source>
        <translation>In die Mitte einer Fläche klicken und die Dicke ihrer Platte eingeben</translation>
    </message>
    <message>
        <source>Click in the middle of a face that stays open, such as the front of a shelf</source>
        <translation>In die Mitte einer Fläche klicken, die offen bleibt, etwa die Front eines Regals</translation>
    </message>
    <message>
        <source>Click in the middle of a face that stays open; click again to close it</source>
        <translation>In die Mitte einer Fläche klicken, die offen bleibt; nochmals klicken schließt sie</translation>
    </message>
    <message>
        <source>Click in the middle of a face, type its thickness and Enter; empty: as the others</source>
        <translation>In die Mitte einer Fläche klicken, Dicke eingeben, Enter; leer: wie die anderen</translation>
    </message>
    <message>
        <source>Click in the middle of the face that it touches; Esc to give up</source>
        <translation>In die Mitte der Fläche klicken, die er berührt; Esc bricht ab</translation>
    </message>
    <message>
        <source>Click or box to select, drag to move; drop a vertex on another one to merge them</source>
        <translation>Klick oder Rahmen wählt aus, Ziehen verschiebt; ein Punkt auf einem anderen wird mit ihm vereint</translation>
    </message>
    <message>
        <source>Click or box to select; drag vertices, edges, circles and their grips to move them</source>
        <translation>Klick oder Rahmen wählt aus; Punkte, Kanten, Kreise und ihre Griffe lassen sich ziehen</translation>
    </message>
    <message>
        <source>Click the box's left corner on the ground</source>
        <translation>Linke Ecke des Quaders am Boden anklicken</translation>
    </message>
    <message>
        <source>Click the corner above the front one</source>
        <translation>Ecke über der vorderen anklicken</translation>
    </message>
    <message>
        <source>Click the corner above the left one</source>
        <translation>Ecke über der linken anklicken</translation>
    </message>
    <message>
        <source>Click the corner above the right one</source>
        <translation>Ecke über der rechten anklicken</translation>
    </message>
    <message>
        <source>Click the end of the line; right click stops; Ctrl: no snapping, Shift: crossings</source>
        <translation>Ende der Linie anklicken; Rechtsklick beendet; Strg: ohne Fang, Umschalt: Kreuzungen</translation>
    </message>
    <message>
        <source>Click the four corners of a printed marker, a sheet of paper or a tile on the ground: it gives the camera and the scale</source>
        <translation>Die vier Ecken einer gedruckten Marke, eines Blatts Papier oder einer Fliese am Boden anklicken: das ergibt Kamera und Maßstab</translation>
    </message>
    <message>
        <source>Click the four corners of something flat on the ground whose size you know, or press the key again to find the printed marker</source>
        <translation>Die vier Ecken von etwas Flachem am Boden anklicken, dessen Größe bekannt ist; die Taste noch einmal sucht die gedruckte Marke</translation>
    </message>
    <message>
        <source>Click the front corner on the ground</source>
        <translation>Vordere Ecke am Boden anklicken</translation>
    </message>
    <message>
        <source>Click the last corner</source>
        <translation>Die letzte Ecke anklicken</translation>
    </message>
    <message>
        <source>Click the middle of an edge that the plane halves; Shift-click picks one by one</source>
        <translation>Die Mitte einer Kante anklicken, die die Ebene halbiert; Umschalt-Klick wählt einzeln</translation>
    </message>
    <message>
        <source>Click the middle of an edge that the plane halves; what is hidden behind is added</source>
        <translation>Die Mitte einer Kante anklicken, die die Ebene halbiert; Verdecktes wird ergänzt</translation>
    </message>
    <message>
        <source>Click the next corner; three are left</source>
        <translation>Die nächste Ecke anklicken; drei fehlen noch</translation>
    </message>
    <message>
        <source>Click the next corner; two are left</source>
        <translation>Die nächste Ecke anklicken; zwei fehlen noch</translation>
    </message>
    <message>
        <source>Click the right corner on the ground</source>
        <translation>Rechte Ecke am Boden anklicken</translation>
    </message>
    <message>
        <source>Click the seven corners that are seen of a box, such as a book in the photo; as construction it gives the perspective</source>
        <translation>Die sieben sichtbaren Ecken eines Quaders anklicken, etwa eines Buches im Foto; als Hilfsgeometrie gibt er die Perspektive</translation>
    </message>
    <message>
        <source>Click the start of the line, or drag</source>
        <translation>Anfang der Linie anklicken oder ziehen</translation>
    </message>
    <message>
        <source>Click the upper corner at the back; X then makes the box construction</source>
        <translation>Obere hintere Ecke anklicken; X macht den Quader dann zur Hilfsgeometrie</translation>
    </message>
    <message>
        <source>Click vertices, edges or the middle of a face that stand on the ground, or box them</source>
        <translation>Punkte, Kanten oder die Mitte einer Fläche anklicken, die auf dem Boden stehen, oder Rahmen ziehen</translation>
    </message>
    <message>
        <source>Click what stands on the ground: vertices, edges, the middle of a face; or box them</source>
        <translation>Anklicken, was auf dem Boden steht: Punkte, Kanten, die Mitte einer Fläche; oder Rahmen ziehen</translation>
    </message>
    <message>
        <source>Click where the side begins, at the edge of the bottom circle</source>
        <translation>Anklicken, wo die Seite beginnt, am Rand des unteren Kreises</translation>
    </message>
    <message>
        <source>Construction</source>
        <translation>Hilfsgeometrie</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Cover for scissors</source>
        <translation>Hülle für eine Schere</translation>
    </message>
    <message>
        <source>Cup saucer</source>
        <translation>Untertasse</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete annotation</source>
        <translation>Angabe löschen</translation>
    </message>
    <message>
        <source>Delete takes back what is said; a second click, or Enter, changes a size</source>
        <translation>Entf nimmt die Angabe zurück; ein zweiter Klick oder die Eingabetaste ändert ein Maß</translation>
    </message>
    <message>
        <source>Desk tidy with a step</source>
        <translation>Stufenkasten für den Schreibtisch</translation>
    </message>
    <message>
        <source>Desktop organizer</source>
        <translation>Schreibtischkasten</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Diameter of circle {}</source>
        <translation>Durchmesser des Kreises {}</translation>
    </message>
    <message>
        <source>Diameter of the round cutter, for the corner relief</source>
        <translation>Durchmesser des Fräsers für die Eckfreistiche</translation>
    </message>
    <message>
        <source>Does it fit?</source>
        <translation>Passt es?</translation>
    </message>
    <message>
        <source>Drag a box around a horizontal circle as it is seen: its ellipse fills the box</source>
        <translation>Rahmen um einen waagrechten Kreis ziehen, wie er im Foto erscheint: seine Ellipse füllt den Rahmen</translation>
    </message>
    <message>
        <source>Drag a box around a horizontal circle as it is seen; pull its four grips afterwards</source>
        <translation>Rahmen um einen waagrechten Kreis ziehen, wie er erscheint; danach an den vier Griffen ziehen</translation>
    </message>
    <message>
        <source>Drag a corner to move it, Delete forgets the camera, four clicks elsewhere begin anew</source>
        <translation>Ecke ziehen verschiebt sie, Entf vergisst die Kamera, vier Klicks daneben beginnen neu</translation>
    </message>
    <message>
        <source>Drag from one corner of the rectangle to the opposite one; move corners afterwards</source>
        <translation>Von einer Ecke des Rechtecks zur gegenüberliegenden ziehen; Ecken danach verschieben</translation>
    </message>
    <message>
        <source>Drag the bottom circle of the new object, or click one that is drawn</source>
        <translation>Den unteren Kreis des neuen Objekts ziehen oder einen gezeichneten anklicken</translation>
    </message>
    <message>
        <source>Drag the circle where it stands on the ground or table, or click one that is drawn</source>
        <translation>Den Kreis ziehen, mit dem es auf Boden oder Tisch steht, oder einen gezeichneten anklicken</translation>
    </message>
    <message>
        <source>Drag the rectangle: it lies level; press the key again to turn it upright</source>
        <translation>Rechteck ziehen: es liegt waagrecht; Taste nochmals stellt es auf</translation>
    </message>
    <message>
        <source>Drag the rectangle: it stands upright; press the key again for any corners</source>
        <translation>Rechteck ziehen: es steht aufrecht; Taste nochmals für beliebige Ecken</translation>
    </message>
    <message>
        <source>Drag the rectangle: it stands upright; press the key again to turn it</source>
        <translation>Rechteck ziehen: es steht aufrecht; Taste nochmals dreht es</translation>
    </message>
    <message>
        <source>Drag the top circle of the new object, or click one that is drawn</source>
        <translation>Den oberen Kreis des neuen Objekts ziehen oder einen gezeichneten anklicken</translation>
    </message>
    <message>
        <source>Drag to move, Shift-click to add, Delete; type a length; right click shows more</source>
        <translation>Ziehen verschiebt, Entf löscht, Umschalt-Klick fügt hinzu; Länge eintippen; Rechtsklick: mehr</translation>
    </message>
    <message>
        <source>Draw a new object over one photo, get a 3D shape and plates to cut</source>
        <translation>Ein neues Objekt über ein Foto zeichnen; heraus kommen eine 3D-Form und Platten zum Schneiden</translation>
    </message>
    <message>
        <source>Draw box</source>
        <translation>Quader zeichnen</translation>
    </message>
    <message>
        <source>Draw circle</source>
        <translation>Kreis zeichnen</translation>
    </message>
    <message>
        <source>Draw line</source>
        <translation>Linie zeichnen</translation>
    </message>
    <message>
        <source>Draw rectangle</source>
        <translation>Rechteck zeichnen</translation>
    </message>
    <message>
        <source>Draw side</source>
        <translation>Seite zeichnen</translation>
    </message>
    <message>
        <source>Draw square</source>
        <translation>Quadrat zeichnen</translation>
    </message>
    <message>
        <source>Draw straight edges, click after click or one with each drag</source>
        <translation>Gerade Kanten zeichnen, Klick um Klick oder je eine mit einem Zug</translation>
    </message>
    <message>
        <source>Draw the ground, bottom and top circle, then the side from bottom to top</source>
        <translation>Boden-, unteren und oberen Kreis zeichnen, dann die Seite von unten nach oben</translation>
    </message>
    <message>
        <source>Draw the new object over the photo: press L for lines, R for rectangles</source>
        <translation>Das neue Objekt über das Foto zeichnen: L für Linien, R für Rechtecke</translation>
    </message>
    <message>
        <source>Drawing of the plates</source>
        <translation>Zeichnung der Platten</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>&amp;Beispiele</translation>
    </message>
    <message>
        <source>Edit sketch</source>
        <translation>Skizze bearbeiten</translation>
    </message>
    <message>
        <source>Equal length</source>
        <translation>Gleich lang</translation>
    </message>
    <message>
        <source>Equal lengths</source>
        <translation>Gleiche Längen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export a PDF in true size too</source>
        <translation>Auch ein PDF in wahrer Größe ausgeben</translation>
    </message>
    <message>
        <source>Export a fit test with these settings too</source>
        <translation>Auch eine Passprobe mit diesen Einstellungen ausgeben</translation>
    </message>
    <message>
        <source>Export plates</source>
        <translation>Platten exportieren</translation>
    </message>
    <message>
        <source>Export plates...</source>
        <translation>Platten exportieren …</translation>
    </message>
    <message>
        <source>Export print</source>
        <translation>Druck exportieren</translation>
    </message>
    <message>
        <source>Export print...</source>
        <translation>Druck exportieren …</translation>
    </message>
    <message>
        <source>Export the parts list too</source>
        <translation>Auch die Stückliste ausgeben</translation>
    </message>
    <message>
        <source>Faces are known once the sketch is solved: the line below says what is missing</source>
        <translation>Flächen sind bekannt, sobald die Skizze gelöst ist: die Zeile unten sagt, was fehlt</translation>
    </message>
    <message>
        <source>Find camera</source>
        <translation>Kamera finden</translation>
    </message>
    <message>
        <source>Finished size of the plate</source>
        <translation>Fertigmaß der Platte</translation>
    </message>
    <message>
        <source>Fit check</source>
        <translation>Passungsprüfung</translation>
    </message>
    <message>
        <source>Fit test</source>
        <translation>Passprobe</translation>
    </message>
    <message>
        <source>Fix or free size</source>
        <translation>Maß festlegen oder freigeben</translation>
    </message>
    <message>
        <source>Fix size</source>
        <translation>Maß festlegen</translation>
    </message>
    <message>
        <source>Fix the length of edges, the diameter of circles or the height of vertices selected in 3D, to type it anew among the model's dimensions; fixed ones follow the drawing again</source>
        <translation>Legt die Länge von Kanten, den Durchmesser von Kreisen oder die Höhe von Punkten fest, die in 3D ausgewählt sind, um sie unter den Maßen des Modells neu einzugeben; festgelegte folgen wieder der Zeichnung</translation>
    </message>
    <message>
        <source>Flat plate</source>
        <translation>Flache Platte</translation>
    </message>
    <message>
        <source>Flat plates</source>
        <translation>Flache Platten</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Follows from the others</source>
        <translation>Folgt aus den anderen</translation>
    </message>
    <message>
        <source>For the parts list; 0 for unknown</source>
        <translation>Für die Stückliste; 0 für unbekannt</translation>
    </message>
    <message>
        <source>For the time, in mm/s</source>
        <translation>Für die Zeit, in mm/s</translation>
    </message>
    <message>
        <source>Forget camera</source>
        <translation>Kamera vergessen</translation>
    </message>
    <message>
        <source>Free border of a sheet</source>
        <translation>Freier Rand eines Bogens</translation>
    </message>
    <message>
        <source>Free size</source>
        <translation>Maß freigeben</translation>
    </message>
    <message>
        <source>Full width that the beam removes; changes the cut paths only, never the plates</source>
        <translation>Volle Breite, die der Strahl wegnimmt; ändert nur die Schnittwege, nie die Platten</translation>
    </message>
    <message>
        <source>Grid: {}</source>
        <translation>Raster: {}</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Ground grid</source>
        <translation>Bodenraster</translation>
    </message>
    <message>
        <source>Have the pen stick to straight edges and corners that are seen in the photo</source>
        <translation>Der Stift rastet an geraden Kanten und Ecken ein, die im Foto zu sehen sind</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height above the ground of {}</source>
        <translation>Höhe über dem Boden von {}</translation>
    </message>
    <message>
        <source>Heights are good to {} % only: have the rectangle larger in the photo.</source>
        <translation>Höhen stimmen nur auf {} %: das Rechteck größer ins Foto nehmen.</translation>
    </message>
    <message>
        <source>How far the triangles of exported files may leave curved surfaces</source>
        <translation>Wie weit die Dreiecke exportierter Dateien von krummen Flächen abweichen dürfen</translation>
    </message>
    <message>
        <source>How many plates there are</source>
        <translation>Wie viele Platten es gibt</translation>
    </message>
    <message>
        <source>How much wider a slot is than the finger that goes into it</source>
        <translation>Um wie viel ein Schlitz breiter ist als der Finger darin</translation>
    </message>
    <message>
        <source>How strong the photo is: fade it to see the lines</source>
        <translation>Wie kräftig das Foto ist: abschwächen, um die Linien zu sehen</translation>
    </message>
    <message>
        <source>How the last recompute ended</source>
        <translation>Wie die letzte Neuberechnung endete</translation>
    </message>
    <message>
        <source>How the plates are joined at each edge</source>
        <translation>Wie die Platten an jeder Kante verbunden sind</translation>
    </message>
    <message>
        <source>How the sketch is lifted. The methods of the papers are slow and less exact: they are there to compare with</source>
        <translation>Wie die Skizze gehoben wird. Die Verfahren der Aufsätze sind langsam und weniger genau: sie sind zum Vergleichen da</translation>
    </message>
    <message>
        <source>How wide fingers should be</source>
        <translation>Wie breit Finger sein sollen</translation>
    </message>
    <message>
        <source>If {} and {} are square at {}, saying so would help most.</source>
        <translation>Stehen {} und {} bei {} senkrecht aufeinander, so hülfe diese Angabe am meisten.</translation>
    </message>
    <message>
        <source>Import sketch</source>
        <translation>Skizze importieren</translation>
    </message>
    <message>
        <source>Import sketch...</source>
        <translation>Skizze importieren …</translation>
    </message>
    <message>
        <source>In which order the plates go together</source>
        <translation>In welcher Reihenfolge die Platten zusammenkommen</translation>
    </message>
    <message>
        <source>Include face</source>
        <translation>Fläche einschließen</translation>
    </message>
    <message>
        <source>Install</source>
        <translation>Installieren</translation>
    </message>
    <message>
        <source>Installing ...</source>
        <translation>Wird installiert …</translation>
    </message>
    <message>
        <source>It is</source>
        <translation>Es ist</translation>
    </message>
    <message>
        <source>It looked towards</source>
        <translation>Blickte auf</translation>
    </message>
    <message>
        <source>Its id</source>
        <translation>Ihre Kennung</translation>
    </message>
    <message>
        <source>Its sizes are unsure: mark more, give a length, or trace something real in the photo.</source>
        <translation>Die Maße sind unsicher: mehr angeben, eine Länge nennen oder etwas Wirkliches im Foto nachzeichnen.</translation>
    </message>
    <message>
        <source>{} cannot hold with the rest: try removing them.</source>
        <translation>{} sind mit dem Rest nicht vereinbar: versuchsweise entfernen.</translation>
    </message>
    <message>
        <source>Only just enough is said, and other shapes may fit as well: mark more.</source>
        <translation>Es ist nur gerade genug gesagt, und andere Formen passen vielleicht ebenso gut: mehr angeben.</translation>
    </message>
    <message>
        <source>Lay the sheet flat on the ground where the new object will stand, and take the photo.</source>
        <translation>Das Blatt flach dorthin legen, wo das neue Ding stehen wird, und das Foto machen.</translation>
    </message>
    <message>
        <source>Layers and colours in files: a shop's or program's name, or your own .json file</source>
        <translation>Ebenen und Farben in Dateien: Name eines Dienstes oder Programms, oder eine eigene .json-Datei</translation>
    </message>
    <message>
        <source>Leave face out</source>
        <translation>Fläche auslassen</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length, diameter</source>
        <translation>Länge, Durchmesser</translation>
    </message>
    <message>
        <source>Let go, or click, at the opposite corner of the box; Esc to give up</source>
        <translation>An der gegenüberliegenden Ecke des Rahmens loslassen oder klicken; Esc bricht ab</translation>
    </message>
    <message>
        <source>Let go, or click, at the opposite corner; Esc to give up</source>
        <translation>An der gegenüberliegenden Ecke loslassen oder klicken; Esc bricht ab</translation>
    </message>
    <message>
        <source>Letter sheet</source>
        <translation>Blatt Letter</translation>
    </message>
    <message>
        <source>Lift to 3D</source>
        <translation>In 3D heben</translation>
    </message>
    <message>
        <source>Lifted model</source>
        <translation>Gehobenes Modell</translation>
    </message>
    <message>
        <source>Lifting by the method {} ...</source>
        <translation>Wird nach dem Verfahren {} gehoben ...</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Lines on straight things bend by up to {} px ({}): the lens distorts, by {} % at the photo's corners: straighten the photo.</source>
        <translation>Linien auf geraden Dingen biegen sich um bis zu {} px ({}): das Objektiv verzeichnet, um {} % in den Ecken des Fotos: das Foto begradigen.</translation>
    </message>
    <message>
        <source>Long edges in the photo bend by up to {} px: the lens distorts, by {} % at the photo's corners: straighten the photo.</source>
        <translation>Lange Kanten im Foto biegen sich um bis zu {} px: das Objektiv verzeichnet, um {} % in den Ecken des Fotos: das Foto begradigen.</translation>
    </message>
    <message>
        <source>Look at the 3D model from where the photo was taken, with the photo behind it; once more brings the old view back</source>
        <translation>Das 3D-Modell von dort sehen, wo das Foto gemacht wurde, mit dem Foto dahinter; nochmals bringt die alte Ansicht zurück</translation>
    </message>
    <message>
        <source>Loose and thin parts</source>
        <translation>Lose und dünne Teile</translation>
    </message>
    <message>
        <source>Loose or thin</source>
        <translation>Lose oder dünn</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Make a TechDraw page of the plates with their main sizes and a parts list</source>
        <translation>Macht eine TechDraw-Seite der Platten mit ihren Hauptmaßen und einer Stückliste</translation>
    </message>
    <message>
        <source>Make a small comb with notches of different play and a tab, with the settings of the plates: cut it first; selected, it is written by Export plates</source>
        <translation>Einen kleinen Kamm mit Kerben verschiedenen Spiels und einen Zapfen erzeugen, mit den Einstellungen der Platten: zuerst schneiden; ausgewählt wird sie von „Platten exportieren“ geschrieben</translation>
    </message>
    <message>
        <source>Make finger-jointed plates of the sketch; thickness, fingers, play and kerf are properties of the result</source>
        <translation>Fingerverzinkte Platten aus der Skizze machen; Dicke, Finger, Spiel und Schnittfuge sind Eigenschaften des Ergebnisses</translation>
    </message>
    <message>
        <source>Make fit test</source>
        <translation>Passprobe erzeugen</translation>
    </message>
    <message>
        <source>Make one hollow solid of the sketch, for a 3D printer; faces left out are openings. The first time takes some seconds</source>
        <translation>Einen Hohlkörper für den 3D-Drucker machen; ausgelassene Flächen sind Öffnungen. Beim ersten Mal dauert es einige Sekunden</translation>
    </message>
    <message>
        <source>Make plates</source>
        <translation>Platten machen</translation>
    </message>
    <message>
        <source>Make shelled solid</source>
        <translation>Hohlkörper machen</translation>
    </message>
    <message>
        <source>Make the 3D model of the sketch; it follows every change of the sketch</source>
        <translation>Das 3D-Modell der Skizze machen; es folgt jeder Änderung</translation>
    </message>
    <message>
        <source>Make the selected edges and circles construction: traced on what is in the photo, no part of the object; or part of it again</source>
        <translation>Ausgewählte Kanten und Kreise zur Hilfsgeometrie machen: im Foto nachgezeichnet, kein Teil des Objekts; oder wieder zu einem Teil</translation>
    </message>
    <message>
        <source>Mark equal length</source>
        <translation>Gleiche Längen festlegen</translation>
    </message>
    <message>
        <source>Mark ground</source>
        <translation>Boden festlegen</translation>
    </message>
    <message>
        <source>Mark on face</source>
        <translation>Lage auf Fläche festlegen</translation>
    </message>
    <message>
        <source>Mark parallel</source>
        <translation>Parallelen festlegen</translation>
    </message>
    <message>
        <source>Mark right angle</source>
        <translation>Rechten Winkel festlegen</translation>
    </message>
    <message>
        <source>Mark symmetry plane</source>
        <translation>Symmetrieebene festlegen</translation>
    </message>
    <message>
        <source>Marker: the black square measures {}</source>
        <translation>Marke: das schwarze Quadrat misst {}</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Merge vertices</source>
        <translation>Punkte vereinen</translation>
    </message>
    <message>
        <source>Modeling in &amp;Context</source>
        <translation>Modeling in &amp;Context</translation>
    </message>
    <message>
        <source>Modeling in Context</source>
        <translation>Modeling in Context</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Move vertex</source>
        <translation>Punkt verschieben</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>New sketch from a photo</source>
        <translation>Neue Skizze aus Foto</translation>
    </message>
    <message>
        <source>New sketch from a photo...</source>
        <translation>Neue Skizze aus Foto …</translation>
    </message>
    <message>
        <source>New sketch from the clipboard</source>
        <translation>Neue Skizze aus der Zwischenablage</translation>
    </message>
    <message>
        <source>No 3D shape fits this drawing; check the annotations against it.</source>
        <translation>Keine 3D-Form passt zu dieser Zeichnung; bitte die Angaben mit ihr vergleichen.</translation>
    </message>
    <message>
        <source>Several traced lines are off: where the photo was cropped, use the whole photo, or say where it looked in the photo's camera.</source>
        <translation>Mehrere nachgezogene Linien passen nicht: wurde das Foto beschnitten, bitte das ganze Foto nehmen oder in der Kamera des Fotos angeben, wohin es blickte.</translation>
    </message>
    <message>
        <source>The photo is blurred there, edges are {} px wide: sizes are less sure; take it with a steady hand, or in more light.</source>
        <translation>Das Foto ist dort unscharf, Kanten sind {} px breit: Größen sind weniger sicher; bitte mit ruhiger Hand oder bei mehr Licht fotografieren.</translation>
    </message>
    <message>
        <source>No camera takes photos of {} x {} px: where this one was cropped, sizes may be off by some percent: use the whole photo, or say where it looked in the photo's camera.</source>
        <translation>Keine Kamera macht Fotos von {} x {} px: wurde dieses beschnitten, können Maße um einige Prozent falsch sein: das ganze Foto nehmen oder bei der Kamera des Fotos sagen, wohin es blickte.</translation>
    </message>
    <message>
        <source>No face is known yet: close a loop of edges with right angles, or list faces</source>
        <translation>Noch keine Fläche bekannt: einen Kantenzug mit rechten Winkeln schließen oder Flächen nennen</translation>
    </message>
    <message>
        <source>No faces were looked for: {}.</source>
        <translation>Es wurden keine Flächen gesucht: {}.</translation>
    </message>
    <message>
        <source>No hollow at all</source>
        <translation>Gar nicht hohl</translation>
    </message>
    <message>
        <source>No shape was found in which all annotations hold: mark more right angles, parallels or ground vertices, or check {}.</source>
        <translation>Keine Form gefunden, in der alle Angaben gelten: mehr rechte Winkel, Parallelen oder Bodenpunkte angeben, oder {} prüfen.</translation>
    </message>
    <message>
        <source>No straight edges are seen between the corners, which are taken as they are: place them well.</source>
        <translation>Zwischen den Ecken sind keine geraden Kanten zu sehen; sie gelten, wie sie sind: genau setzen.</translation>
    </message>
    <message>
        <source>No straight thing is seen: draw lines along some, near the photo's borders, and make them construction (X).</source>
        <translation>Kein gerades Ding ist zu sehen: Linien entlang gerader Dinge ziehen, nahe am Rand des Fotos, und zu Hilfsgeometrie machen (X).</translation>
    </message>
    <message>
        <source>{} cannot hold with what is said of the circles and the rest of the side: take one of these away.</source>
        <translation>{} kann nicht zusammen mit dem gelten, was über die Kreise und den Rest der Seite gesagt ist: etwas davon wegnehmen.</translation>
    </message>
    <message>
        <source>Not flat enough for a face: {}, {} mm off: mark right angles or parallels there, or take it for a face.</source>
        <translation>Nicht eben genug für eine Fläche: {}, {} mm daneben: dort rechte Winkel oder Parallelen markieren, oder es als Fläche nehmen.</translation>
    </message>
    <message>
        <source>Where {} is flat, taking it for a face would help.</source>
        <translation>Wo {} eben ist, hilft es, es als Fläche zu nehmen.</translation>
    </message>
    <message>
        <source>No face was found for {}: choose another one.</source>
        <translation>Für {} wurde keine Fläche gefunden: bitte eine andere wählen.</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Nothing is traced on the photo to fit to. Draw what is there with the line, box or circle tool and press X to make it construction.</source>
        <translation>Auf dem Foto ist nichts nachgezeichnet, wozu es passen soll. Vorhandenes mit Linie, Quader oder Kreis zeichnen und mit X zu Hilfsgeometrie machen.</translation>
    </message>
    <message>
        <source>Of new plates</source>
        <translation>Neuer Platten</translation>
    </message>
    <message>
        <source>Of new shelled solids</source>
        <translation>Neuer Hohlkörper</translation>
    </message>
    <message>
        <source>Of the object alone</source>
        <translation>Des Gegenstands allein</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Abw.</translation>
    </message>
    <message>
        <source>On a face</source>
        <translation>Auf einer Fläche</translation>
    </message>
    <message>
        <source>On face</source>
        <translation>Auf Fläche</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Auf dem Boden</translation>
    </message>
    <message>
        <source>One drag makes four edges and four right angles, in perspective once that is known; move the corners afterwards</source>
        <translation>Ein Zug macht vier Kanten und vier rechte Winkel, in Perspektive, sobald sie bekannt ist; Ecken danach verschieben</translation>
    </message>
    <message>
        <source>Open a .sketch.json file; its photo is taken from beside it</source>
        <translation>Eine .sketch.json-Datei öffnen; das Foto daneben wird mitgenommen</translation>
    </message>
    <message>
        <source>Open the bookshelf example</source>
        <translation>Beispiel Bücherregal öffnen</translation>
    </message>
    <message>
        <source>Or in a terminal:</source>
        <translation>Oder im Terminal:</translation>
    </message>
    <message>
        <source>Other joints at some edges, such as e5=butt or f1:f2=finger,finger=8,owner=f1; kinds: auto, finger, butt, half_lap, tab_slot, none</source>
        <translation>Andere Verbindungen an einigen Kanten, etwa e5=butt oder f1:f2=finger,finger=8,owner=f1; Arten: auto, finger, butt, half_lap, tab_slot, none</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;SVG (*.svg)</source>
        <translation>PDF (*.pdf);;SVG (*.svg)</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Parameter numbers</source>
        <translation>Anzahl der Parameter</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Stückliste</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Photo sketch</source>
        <translation>Fotoskizze</translation>
    </message>
    <message>
        <source>Photo's middle</source>
        <translation>Mitte des Fotos</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Plate {}</source>
        <translation>Platte {}</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Platten</translation>
    </message>
    <message>
        <source>Plates for a laser, over a cropped photo</source>
        <translation>Platten für den Laser, über einem beschnittenen Foto</translation>
    </message>
    <message>
        <source>Plates for a laser, over a photo of stationery</source>
        <translation>Platten für den Laser, über dem Foto von Schreibsachen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Presets of your own, as .json files like ours, belong in {}</source>
        <translation>Eigene Vorgaben gehören als .json-Dateien wie unsere in {}</translation>
    </message>
    <message>
        <source>Print marker</source>
        <translation>Marke drucken</translation>
    </message>
    <message>
        <source>Print marker...</source>
        <translation>Marke drucken...</translation>
    </message>
    <message>
        <source>Printed marker</source>
        <translation>Gedruckte Marke</translation>
    </message>
    <message>
        <source>Put another photo under the sketch; a photo can also be dropped on it or pasted</source>
        <translation>Ein anderes Foto unter die Skizze legen; es lässt sich auch hineinziehen oder einfügen</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Rectangle and drawing do not agree: check both.</source>
        <translation>Rechteck und Zeichnung passen nicht zusammen: bitte beide prüfen.</translation>
    </message>
    <message>
        <source>Refine by the drawing</source>
        <translation>Mit der Zeichnung verfeinern</translation>
    </message>
    <message>
        <source>Refine camera</source>
        <translation>Kamera verfeinern</translation>
    </message>
    <message>
        <source>Remove on face</source>
        <translation>Lage auf Fläche entfernen</translation>
    </message>
    <message>
        <source>Remove right angle</source>
        <translation>Rechten Winkel entfernen</translation>
    </message>
    <message>
        <source>Remove symmetry plane</source>
        <translation>Symmetrieebene entfernen</translation>
    </message>
    <message>
        <source>Replace photo</source>
        <translation>Foto ersetzen</translation>
    </message>
    <message>
        <source>Replace photo...</source>
        <translation>Foto ersetzen …</translation>
    </message>
    <message>
        <source>Right angle</source>
        <translation>Rechter Winkel</translation>
    </message>
    <message>
        <source>Room for a round cutter in corners that look inwards; a laser needs none</source>
        <translation>Platz für einen runden Fräser in Innenecken; ein Laser braucht keinen</translation>
    </message>
    <message>
        <source>Say where the middle of the whole photo was; or trace a box in the photo (key B, then X), and its lines tell it.</source>
        <translation>Bitte sagen, wo die Mitte des ganzen Fotos war; oder einen Quader im Foto nachzeichnen (Taste B, dann X): seine Linien sagen es.</translation>
    </message>
    <message>
        <source>See and say what is known of the camera: its focal length, and in a cropped photo where it looked</source>
        <translation>Sehen und sagen, was von der Kamera bekannt ist: ihre Brennweite, und bei einem beschnittenen Foto, wohin sie blickte</translation>
    </message>
    <message>
        <source>Seen from straight above, heights are hardly to be told: take the photo from lower down.</source>
        <translation>Von genau oben sind Höhen kaum zu erkennen: das Foto von weiter unten machen.</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Set diameter</source>
        <translation>Durchmesser setzen</translation>
    </message>
    <message>
        <source>Set length</source>
        <translation>Länge setzen</translation>
    </message>
    <message>
        <source>Set thickness</source>
        <translation>Dicke setzen</translation>
    </message>
    <message>
        <source>Shelled solid</source>
        <translation>Hohlkörper</translation>
    </message>
    <message>
        <source>Shift-click more middles, then Enter or right click; Esc to give up</source>
        <translation>Mit Umschalt-Klick weitere Mitten wählen, dann Enter oder Rechtsklick; Esc bricht ab</translation>
    </message>
    <message>
        <source>Show a grid on the ground in the photo's perspective, once that is known; the pen sticks to its lines and crossings</source>
        <translation>Zeigt ein Raster am Boden in der Perspektive des Fotos, sobald sie bekannt ist; der Stift rastet an seinen Linien und Kreuzungen ein</translation>
    </message>
    <message>
        <source>Show at each vertex how many of its three coordinates are still its own: what is said of the sketch gives the others</source>
        <translation>An jedem Punkt zeigen, wie viele seiner drei Koordinaten noch eigene sind: die anderen ergeben sich aus den Angaben</translation>
    </message>
    <message>
        <source>Show the photo and the sketch over it; drag a vertex, and the model follows</source>
        <translation>Foto und Skizze zeigen; beim Ziehen eines Punktes folgt das Modell</translation>
    </message>
    <message>
        <source>Show the plates apart, the way they are put together</source>
        <translation>Die Platten auseinandergezogen zeigen, wie sie zusammengesetzt werden</translation>
    </message>
    <message>
        <source>Show the sheets and the length of the cuts, and write DXF, SVG, PDF, STEP and lists; where a fit test is selected, write that</source>
        <translation>Zeigt die Platten auf ihren Tafeln und die Länge der Schnitte und schreibt DXF, SVG, PDF, STEP und Listen; ist ein Passungstest ausgewählt, dann diesen</translation>
    </message>
    <message>
        <source>Show the whole photo (F)</source>
        <translation>Ganzes Foto zeigen (F)</translation>
    </message>
    <message>
        <source>Side of the black square</source>
        <translation>Seite des schwarzen Quadrats</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Size of the stock</source>
        <translation>Größe des Bogens</translation>
    </message>
    <message>
        <source>Size of the stock; 0 takes the smallest usual sheet that holds every plate</source>
        <translation>Größe des Bogens; 0 nimmt den kleinsten üblichen, auf den jede Platte passt</translation>
    </message>
    <message>
        <source>Sketch &amp;tools</source>
        <translation>Skizzen&amp;werkzeuge</translation>
    </message>
    <message>
        <source>Sketch tools</source>
        <translation>Skizzenwerkzeuge</translation>
    </message>
    <message>
        <source>Sketches (*.sketch.json);;All files (*)</source>
        <translation>Skizzen (*.sketch.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Solved without {}.</source>
        <translation>Gelöst ohne {}.</translation>
    </message>
    <message>
        <source>Correct {}, or take it away.</source>
        <translation>Bitte {} berichtigen oder wegnehmen.</translation>
    </message>
    <message>
        <source>Solved, but a second shape, with near and far exchanged, fits as well: mark what stands on the ground, or ask for the twin.</source>
        <translation>Gelöst, aber eine zweite Form, nah und fern vertauscht, passt ebenso gut: bitte markieren, was auf dem Boden steht, oder den Zwilling verlangen.</translation>
    </message>
    <message>
        <source>Stopped before the end: this is as far as it came.</source>
        <translation>Vor dem Ende angehalten: so weit ist es gekommen.</translation>
    </message>
    <message>
        <source>Solved, but seen from below: mark what stands on the ground.</source>
        <translation>Gelöst, aber von unten gesehen: bitte markieren, was auf dem Boden steht.</translation>
    </message>
    <message>
        <source>Nothing is said to be square or parallel: begin with right angles at {}.</source>
        <translation>Nichts ist als rechtwinklig oder parallel angegeben: bitte mit rechten Winkeln an {} beginnen.</translation>
    </message>
    <message>
        <source>Solved, but seen from below: check the ground vertices.</source>
        <translation>Gelöst, aber von unten gesehen: bitte die Bodenpunkte prüfen.</translation>
    </message>
    <message>
        <source>The drawing is missed by {} px.</source>
        <translation>Die Zeichnung wird um {} px verfehlt.</translation>
    </message>
    <message>
        <source>Solved, but the drawing is missed by {} px: check the annotations against it.</source>
        <translation>Gelöst, aber die Zeichnung wird um {} px verfehlt: bitte die Angaben mit ihr vergleichen.</translation>
    </message>
    <message>
        <source>Solved, but the drawing is missed by {} px: check {}.</source>
        <translation>Gelöst, aber die Zeichnung wird um {} px verfehlt: bitte {} prüfen.</translation>
    </message>
    <message>
        <source>Solved, but {} contradicts the drawing, which is missed by {} px.</source>
        <translation>Gelöst, aber {} widerspricht der Zeichnung, die um {} px verfehlt wird.</translation>
    </message>
    <message>
        <source>Solved, but {} contradicts the drawing: with it the drawing is missed by {} px, without it by {} px.</source>
        <translation>Gelöst, aber {} widerspricht der Zeichnung: damit wird sie um {} px verfehlt, ohne um {} px.</translation>
    </message>
    <message>
        <source>Solved, with a usual focal length assumed: the drawing does not tell it.</source>
        <translation>Gelöst, mit einer üblichen Brennweite: die Zeichnung verrät sie nicht.</translation>
    </message>
    <message>
        <source>Solved, with what is drawn nearly square taken to be square: mark right angles where it is.</source>
        <translation>Gelöst; was nahezu rechtwinklig gezeichnet ist, gilt als rechtwinklig: bitte die rechten Winkel markieren.</translation>
    </message>
    <message>
        <source>Solved.</source>
        <translation>Gelöst.</translation>
    </message>
    <message>
        <source>Something else</source>
        <translation>Etwas anderes</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Stick to the photo's edges</source>
        <translation>An Kanten des Fotos einrasten</translation>
    </message>
    <message>
        <source>Stopped; nothing is installed.</source>
        <translation>Abgebrochen; nichts wurde installiert.</translation>
    </message>
    <message>
        <source>Storage box for a chair</source>
        <translation>Kiste unter einem Stuhl</translation>
    </message>
    <message>
        <source>Straighten photo</source>
        <translation>Foto begradigen</translation>
    </message>
    <message>
        <source>Surface of revolution</source>
        <translation>Drehfläche</translation>
    </message>
    <message>
        <source>Symmetry plane</source>
        <translation>Symmetrieebene</translation>
    </message>
    <message>
        <source>Take the suggestion (Y)</source>
        <translation>Vorschlag übernehmen (Y)</translation>
    </message>
    <message>
        <source>Take all {} suggestions (Y)</source>
        <translation>Alle {} Vorschläge übernehmen (Y)</translation>
    </message>
    <message>
        <source>Take suggestions</source>
        <translation>Vorschläge übernehmen</translation>
    </message>
    <message>
        <source>Take the lens's distortion out of the photo: its long edges, and lines traced on straight things as construction, tell how it bends them</source>
        <translation>Die Verzeichnung des Objektivs aus dem Foto nehmen: dessen lange Kanten und als Hilfsgeometrie auf geraden Dingen nachgezeichnete Linien verraten, wie es sie biegt</translation>
    </message>
    <message>
        <source>Take the picture, or the picture file, that was copied last as the photo</source>
        <translation>Das zuletzt kopierte Bild oder die Bilddatei als Foto nehmen</translation>
    </message>
    <message>
        <source>Teapot lid</source>
        <translation>Deckel einer Teekanne</translation>
    </message>
    <message>
        <source>Test the plates or the solid against the things traced on the photo, and whether they stand: clearance, overlaps in red, centre of mass, loose and thin parts</source>
        <translation>Platten oder Körper gegen die auf dem Foto nachgezeichneten Dinge prüfen, und ob sie stehen: Abstand, Überschneidungen in Rot, Schwerpunkt, lose und dünne Teile</translation>
    </message>
    <message>
        <source>That did not work:</source>
        <translation>Das hat nicht geklappt:</translation>
    </message>
    <message>
        <source>The corners are {} px off any rectangle of this size: check the size, that it lies flat, and that the photo was not cropped.</source>
        <translation>Die Ecken liegen {} px neben jedem Rechteck dieser Größe: die Größe prüfen, ob es flach liegt, und ob das Foto beschnitten ist.</translation>
    </message>
    <message>
        <source>The corners do not tell which side is the longer one: check the grid on the ground, or keep the photo's EXIF data.</source>
        <translation>Die Ecken verraten nicht, welche Seite die längere ist: das Raster am Boden prüfen oder die EXIF-Daten des Fotos behalten.</translation>
    </message>
    <message>
        <source>The corners do not tell which way the ground leans: have the rectangle larger in the photo, and check the grid on the ground.</source>
        <translation>Die Ecken verraten nicht, wie der Boden geneigt ist: das Rechteck größer ins Foto nehmen und das Raster am Boden prüfen.</translation>
    </message>
    <message>
        <source>The drawing and the annotations are too far apart: check the annotations.</source>
        <translation>Zeichnung und Angaben liegen zu weit auseinander: bitte die Angaben prüfen.</translation>
    </message>
    <message>
        <source>The drawing does not tell the focal length: a usual one is assumed.</source>
        <translation>Die Zeichnung verrät die Brennweite nicht: eine übliche wird angenommen.</translation>
    </message>
    <message>
        <source>The focal length was {0:.1f} mm and is {1:.1f} mm.</source>
        <translation>Die Brennweite war {0:.1f} mm und ist {1:.1f} mm.</translation>
    </message>
    <message>
        <source>The given lengths put the camera {} mm ({} %) off its known height: check the length, the camera, and what stands on the ground.</source>
        <translation>Die angegebenen Längen versetzen die Kamera um {} mm ({} %) gegenüber ihrer bekannten Höhe: bitte Länge, Kamera und was am Boden steht prüfen.</translation>
    </message>
    <message>
        <source>The grid shows once the sketch is solved</source>
        <translation>Das Raster erscheint, sobald die Skizze gelöst ist</translation>
    </message>
    <message>
        <source>The model that is hollowed out</source>
        <translation>Das Modell, das ausgehöhlt wird</translation>
    </message>
    <message>
        <source>The model that plates are made of</source>
        <translation>Das Modell, aus dem Platten werden</translation>
    </message>
    <message>
        <source>The photo, kept inside the document</source>
        <translation>Das Foto, im Dokument gespeichert</translation>
    </message>
    <message>
        <source>The plates or the solid that are checked</source>
        <translation>Die Platten oder der Körper, die geprüft werden</translation>
    </message>
    <message>
        <source>The plates that it is one of</source>
        <translation>Die Platten, von denen sie eine ist</translation>
    </message>
    <message>
        <source>The plates whose settings it tries</source>
        <translation>Die Platten, deren Einstellungen sie erprobt</translation>
    </message>
    <message>
        <source>The play of each notch in mm, from left to right; it is engraved beside it</source>
        <translation>Das Spiel jeder Kerbe in mm, von links nach rechts; es ist daneben eingraviert</translation>
    </message>
    <message>
        <source>The polygon on which it stands</source>
        <translation>Das Vieleck, auf dem es steht</translation>
    </message>
    <message>
        <source>The rectangle is seen too square-on to tell the focal length, which is good to {} % only: take the photo from lower down, or keep its EXIF data.</source>
        <translation>Das Rechteck ist zu sehr von oben zu sehen, um die Brennweite zu verraten; sie stimmt nur auf {} %: das Foto von weiter unten machen oder seine EXIF-Daten behalten.</translation>
    </message>
    <message>
        <source>The rectangle tells {0:.0f} mm.</source>
        <translation>Das Rechteck sagt {0:.0f} mm.</translation>
    </message>
    <message>
        <source>The sketch has no edges: draw the object's edges over the photo.</source>
        <translation>Die Skizze hat keine Kanten: bitte die Kanten des Objekts über das Foto zeichnen.</translation>
    </message>
    <message>
        <source>The sketch that is lifted to 3D</source>
        <translation>Die Skizze, die in 3D gehoben wird</translation>
    </message>
    <message>
        <source>The traced line {} is {} px ({} degrees) off the perspective of the rest: check it.</source>
        <translation>Die nachgezeichnete Linie {} liegt {} px ({} Grad) neben der Perspektive der übrigen: prüfen.</translation>
    </message>
    <message>
        <source>Straight lines bend by {:.1f} px at most: there is nothing to straighten.</source>
        <translation>Gerade Linien biegen sich um höchstens {:.1f} px: es gibt nichts zu begradigen.</translation>
    </message>
    <message>
        <source>The traced lines meet as in a cropped photo: it was taken towards {} px, not {} px: say so in the photo's camera, or use the whole photo.</source>
        <translation>Die nachgezeichneten Linien treffen sich wie in einem beschnittenen Foto: es blickt auf {} px, nicht auf {} px: das bei der Kamera des Fotos sagen, oder das ganze Foto nehmen.</translation>
    </message>
    <message>
        <source>The traced lines say: towards {0:.0f}, {1:.0f} px, good to {2:.0f} px.</source>
        <translation>Die nachgezeichneten Linien sagen: auf {0:.0f}, {1:.0f} px, auf {2:.0f} px genau.</translation>
    </message>
    <message>
        <source>The traced lines {} are too nearly parallel in the photo to tell where they meet: trace others further apart, or use a marker.</source>
        <translation>Die nachgezeichneten Linien {} sind im Foto zu parallel, um zu verraten, wo sie sich treffen: weiter auseinander liegende nachzeichnen oder eine Marke verwenden.</translation>
    </message>
    <message>
        <source>There is no photo: choose one first.</source>
        <translation>Es gibt kein Foto: bitte zuerst eines wählen.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness of the sheets, for faces that name none of their own</source>
        <translation>Dicke der Bögen, für Flächen ohne eigene Angabe</translation>
    </message>
    <message>
        <source>Thickness of the wall</source>
        <translation>Dicke der Wand</translation>
    </message>
    <message>
        <source>This line is 100 mm long. If yours is not, print again at 100 %, not fitted to the page.</source>
        <translation>Diese Linie ist 100 mm lang. Wenn nicht: noch einmal mit 100 % drucken, nicht an die Seite angepasst.</translation>
    </message>
    <message>
        <source>This needs Python packages that are not installed: {}.
They are put into FreeCAD's own folder, and may take some minutes and up to 2 GB.</source>
        <translation>Dafür fehlen Python-Pakete: {}.
Sie kommen in FreeCADs eigenen Ordner; das kann einige Minuten dauern und bis zu 2 GB brauchen.</translation>
    </message>
    <message>
        <source>This photo seems cropped: no camera takes photos of {0} x {1} px.</source>
        <translation>Dieses Foto scheint beschnitten: keine Kamera macht Fotos von {0} x {1} px.</translation>
    </message>
    <message>
        <source>This photo seems cropped: the camera wrote {0} x {1} px, {2} x {3} px are left.</source>
        <translation>Dieses Foto scheint beschnitten: die Kamera schrieb {0} x {1} px, {2} x {3} px sind übrig.</translation>
    </message>
    <message>
        <source>Tile the PDF on A4, A3 or letter pages</source>
        <translation>Das PDF auf A4-, A3- oder Letter-Seiten verteilen</translation>
    </message>
    <message>
        <source>Too many copies ({} and so on): take some symmetry planes away.</source>
        <translation>Zu viele Kopien ({} und so weiter): bitte einige Symmetrieebenen wegnehmen.</translation>
    </message>
    <message>
        <source>True where no length says how big the object is: its longest edge is 100 mm then</source>
        <translation>Wahr, wo keine Länge die Größe angibt: die längste Kante ist dann 100 mm</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Nochmals versuchen</translation>
    </message>
    <message>
        <source>Type a length, such as 210, 21 cm, 3/4 in or 2*18 mm + 5 mm</source>
        <translation>Bitte eine Länge eingeben, etwa 210, 21 cm, 3/4 in oder 2*18 mm + 5 mm</translation>
    </message>
    <message>
        <source>Unknowns: {} before, {} with what is true</source>
        <translation>Unbekannte: vorher {}, mit dem, was gilt, {}</translation>
    </message>
    <message>
        <source>View through photo</source>
        <translation>Durch das Foto sehen</translation>
    </message>
    <message>
        <source>What fingers, play and kerf come to, in millimetres</source>
        <translation>Was Finger, Spiel und Schnittfuge ergeben, in Millimetern</translation>
    </message>
    <message>
        <source>What in the photo tells the camera: four corners in px, and the sides in mm</source>
        <translation>Was im Foto die Kamera ergibt: vier Ecken in px, und die Seiten in mm</translation>
    </message>
    <message>
        <source>What is true</source>
        <translation>Was gilt</translation>
    </message>
    <message>
        <source>What the last recompute has to say</source>
        <translation>Was die letzte Neuberechnung zu sagen hat</translation>
    </message>
    <message>
        <source>What the object shares with existing things</source>
        <translation>Was der Gegenstand mit vorhandenen Dingen gemeinsam hat</translation>
    </message>
    <message>
        <source>What the printer can print at once, in mm; 0 for unknown</source>
        <translation>Was der Drucker auf einmal drucken kann, in mm; 0 für unbekannt</translation>
    </message>
    <message>
        <source>What the printer can print; thinner walls are refused</source>
        <translation>Was der Drucker drucken kann; dünnere Wände werden abgelehnt</translation>
    </message>
    <message>
        <source>What was drawn over the photo, as the text of a sketch file</source>
        <translation>Was über das Foto gezeichnet wurde, als Text einer Skizzendatei</translation>
    </message>
    <message>
        <source>Where the direction that is up lies on the sheet</source>
        <translation>Wo die Richtung nach oben auf dem Bogen liegt</translation>
    </message>
    <message>
        <source>Where the material lies: inside means that the drawn faces are the outside</source>
        <translation>Wo das Material liegt: innen heißt, die gezeichneten Flächen sind außen</translation>
    </message>
    <message>
        <source>Where the wall lies: inside means that the drawn faces are the outside</source>
        <translation>Wo die Wand liegt: innen heißt, die gezeichneten Flächen sind außen</translation>
    </message>
    <message>
        <source>Whether each of these things fits</source>
        <translation>Ob jedes dieser Dinge passt</translation>
    </message>
    <message>
        <source>Whether it stands, and when it tips over</source>
        <translation>Ob es steht, und wann es kippt</translation>
    </message>
    <message>
        <source>Whether it stays as it is</source>
        <translation>Ob es so stehen bleibt</translation>
    </message>
    <message>
        <source>Which end of a surface of revolution has no wall</source>
        <translation>Welches Ende einer Drehfläche keine Wand hat</translation>
    </message>
    <message>
        <source>Which of them</source>
        <translation>Welche davon</translation>
    </message>
    <message>
        <source>Which plate each of the solids is</source>
        <translation>Welche Platte jeder der Körper ist</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Will it stand?</source>
        <translation>Steht es?</translation>
    </message>
    <message>
        <source>Wood for a laser, over a photo of six books on a desk</source>
        <translation>Holz für den Laser, über dem Foto von sechs Büchern auf einem Tisch</translation>
    </message>
    <message>
        <source>Write a marker to print as PDF or SVG: on the ground in a photo, it gives the camera and the scale</source>
        <translation>Eine Marke zum Drucken als PDF oder SVG schreiben: liegt sie im Foto am Boden, ergibt sie Kamera und Maßstab</translation>
    </message>
    <message>
        <source>Write the plates as DXF, SVG, STEP and plates.json into a folder; where a fit test is selected, write that</source>
        <translation>Die Platten als DXF, SVG, STEP und plates.json in einen Ordner schreiben; ist eine Passprobe ausgewählt, dann diese</translation>
    </message>
    <message>
        <source>Write the shelled solid as STL, 3MF and STEP into a folder</source>
        <translation>Den Hohlkörper als STL, 3MF und STEP in einen Ordner schreiben</translation>
    </message>
    <message>
        <source>a closed set of faces</source>
        <translation>geschlossene Flächen</translation>
    </message>
    <message>
        <source>a joint names no edge</source>
        <translation>eine Verbindung nennt keine Kante</translation>
    </message>
    <message>
        <source>a larger printer, or several parts</source>
        <translation>ein größerer Drucker oder mehrere Teile</translation>
    </message>
    <message>
        <source>a larger sheet, or a smaller margin</source>
        <translation>eine größere Tafel oder einen kleineren Rand</translation>
    </message>
    <message>
        <source>a larger sheet, or another grain</source>
        <translation>eine größere Tafel oder eine andere Faserrichtung</translation>
    </message>
    <message>
        <source>a hole of {} x {} mm is narrower than the kerf of {} mm</source>
        <translation>ein Loch von {} x {} mm ist schmaler als die Schnittfuge von {} mm</translation>
    </message>
    <message>
        <source>a notch that a beam of {} mm just gets into is narrower than the kerf of {} mm</source>
        <translation>eine Kerbe, in die ein Strahl von {} mm gerade noch passt, ist schmaler als die Schnittfuge von {} mm</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>eine größere Tafel</translation>
    </message>
    <message>
        <source>a lifted model</source>
        <translation>ein gehobenes Modell</translation>
    </message>
    <message>
        <source>a notch or hole has no room for a cutter of {} mm: one of {} mm just gets in</source>
        <translation>eine Kerbe oder ein Loch hat keinen Platz für einen Fräser von {} mm: einer von {} mm passt gerade noch</translation>
    </message>
    <message>
        <source>a number from {} to {} mm</source>
        <translation>eine Zahl von {} bis {} mm</translation>
    </message>
    <message>
        <source>a number from {} to {} {}</source>
        <translation>eine Zahl von {} bis {} {}</translation>
    </message>
    <message>
        <source>a photo sketch</source>
        <translation>eine Fotoskizze</translation>
    </message>
    <message>
        <source>a plate of {} x {} mm does not fit on a sheet of {} x {} mm with a margin of {} mm</source>
        <translation>eine Platte von {} x {} mm passt nicht auf eine Tafel von {} x {} mm mit {} mm Rand</translation>
    </message>
    <message>
        <source>a plate set</source>
        <translation>einen Plattensatz</translation>
    </message>
    <message>
        <source>a shelled solid</source>
        <translation>einen Hohlkörper</translation>
    </message>
    <message>
        <source>a side that runs from circle to circle</source>
        <translation>eine Seite, die von Kreis zu Kreis läuft</translation>
    </message>
    <message>
        <source>a thicker wall</source>
        <translation>eine dickere Wand</translation>
    </message>
    <message>
        <source>a thicker wall, or a printer with a finer nozzle</source>
        <translation>eine dickere Wand oder ein Drucker mit feinerer Düse</translation>
    </message>
    <message>
        <source>a thickness above 0 mm</source>
        <translation>eine Dicke über 0 mm</translation>
    </message>
    <message>
        <source>a thickness of {} mm</source>
        <translation>eine Dicke von {} mm</translation>
    </message>
    <message>
        <source>a thinner cutter, or wider fingers</source>
        <translation>ein dünnerer Fräser oder breitere Zinken</translation>
    </message>
    <message>
        <source>a thinner or thicker wall</source>
        <translation>eine dünnere oder dickere Wand</translation>
    </message>
    <message>
        <source>a thinner wall</source>
        <translation>eine dünnere Wand</translation>
    </message>
    <message>
        <source>a thinner wall, or the other side</source>
        <translation>eine dünnere Wand oder die andere Seite</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>another folder, or check its permissions</source>
        <translation>ein anderer Ordner, oder seine Rechte prüfen</translation>
    </message>
    <message>
        <source>another format</source>
        <translation>ein anderes Format</translation>
    </message>
    <message>
        <source>butt</source>
        <translation>stumpfer Stoß</translation>
    </message>
    <message>
        <source>cannot write {}: {}</source>
        <translation>{} lässt sich nicht schreiben: {}</translation>
    </message>
    <message>
        <source>choose a lifted model</source>
        <translation>bitte ein gehobenes Modell wählen</translation>
    </message>
    <message>
        <source>choose a photo sketch</source>
        <translation>bitte eine Fotoskizze wählen</translation>
    </message>
    <message>
        <source>choose plates</source>
        <translation>bitte Platten wählen</translation>
    </message>
    <message>
        <source>choose plates or a shelled solid</source>
        <translation>bitte Platten oder einen Hohlkörper wählen</translation>
    </message>
    <message>
        <source>close a loop of edges that lies in one plane, or include a face</source>
        <translation>einen ebenen Kantenzug schließen oder eine Fläche aufnehmen</translation>
    </message>
    <message>
        <source>cut it first; the notch in which the tab sits well says which play to set</source>
        <translation>zuerst schneiden; die Kerbe, in der der Zapfen gut sitzt, sagt das richtige Spiel</translation>
    </message>
    <message>
        <source>cutter</source>
        <translation>Schneidmaschine</translation>
    </message>
    <message>
        <source>delete it or draw it again</source>
        <translation>löschen oder neu zeichnen</translation>
    </message>
    <message>
        <source>draw the face's edges in order</source>
        <translation>die Kanten der Fläche der Reihe nach zeichnen</translation>
    </message>
    <message>
        <source>draw the face's edges in order, without crossing</source>
        <translation>die Kanten der Fläche der Reihe nach und ohne Kreuzung zeichnen</translation>
    </message>
    <message>
        <source>draw the missing face; leave it out</source>
        <translation>die fehlende Fläche zeichnen; weglassen</translation>
    </message>
    <message>
        <source>faces that meet in their edges only</source>
        <translation>Flächen, die sich nur in ihren Kanten treffen</translation>
    </message>
    <message>
        <source>fingers cannot hold here: {}</source>
        <translation>Zinken können hier nicht halten: {}</translation>
    </message>
    <message>
        <source>fingers of {} mm cannot hold here</source>
        <translation>Zinken von {} mm halten hier nicht</translation>
    </message>
    <message>
        <source>{} mm or wider</source>
        <translation>{} mm oder breiter</translation>
    </message>
    <message>
        <source>tabs cannot hold here: {}</source>
        <translation>Zapfen halten hier nicht: {}</translation>
    </message>
    <message>
        <source>flat faces beside a surface of revolution cannot be printed as one</source>
        <translation>ebene Flächen neben einem Drehkörper lassen sich nicht als eines drucken</translation>
    </message>
    <message>
        <source>follows from the drawing and the other dimensions</source>
        <translation>folgt aus der Zeichnung und den anderen Maßen</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>include a face</source>
        <translation>eine Fläche aufnehmen</translation>
    </message>
    <message>
        <source>it does not stand</source>
        <translation>es steht nicht</translation>
    </message>
    <message>
        <source>it fits</source>
        <translation>es passt</translation>
    </message>
    <message>
        <source>it has no name of 1 to 60 letters</source>
        <translation>es hat keinen Namen von 1 bis 60 Zeichen</translation>
    </message>
    <message>
        <source>it is no JSON object</source>
        <translation>es ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>it stands</source>
        <translation>es steht</translation>
    </message>
    <message>
        <source>key {} in the sketch</source>
        <translation>Taste {} in der Skizze</translation>
    </message>
    <message>
        <source>lay it on another side</source>
        <translation>auf eine andere Seite legen</translation>
    </message>
    <message>
        <source>leave one of the faces out</source>
        <translation>eine der Flächen weglassen</translation>
    </message>
    <message>
        <source>leave them out, or sketch them on their own</source>
        <translation>weglassen oder für sich skizzieren</translation>
    </message>
    <message>
        <source>list the faces in the sketch</source>
        <translation>die Flächen in der Skizze aufführen</translation>
    </message>
    <message>
        <source>mm (35 mm equivalent)</source>
        <translation>mm (Kleinbild)</translation>
    </message>
    <message>
        <source>more than two outer faces meet in these edges</source>
        <translation>mehr als zwei Außenflächen treffen sich in diesen Kanten</translation>
    </message>
    <message>
        <source>more than {} pairs of edges meet</source>
        <translation>mehr als {} Kantenpaare treffen sich</translation>
    </message>
    <message>
        <source>no face to make a plate of</source>
        <translation>keine Fläche für eine Platte</translation>
    </message>
    <message>
        <source>no face to make anything of</source>
        <translation>keine Fläche, aus der sich etwas machen ließe</translation>
    </message>
    <message>
        <source>no two plates meet there</source>
        <translation>dort treffen sich keine zwei Platten</translation>
    </message>
    <message>
        <source>no wall of {} mm can be made</source>
        <translation>eine Wand von {} mm lässt sich nicht herstellen</translation>
    </message>
    <message>
        <source>no {} joint can be made where {}</source>
        <translation>es lässt sich keine Verbindung „{}“ herstellen, wo {}</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>walls touch each other in an edge only, which makes no solid</source>
        <translation>Wände berühren einander nur in einer Kante, das ergibt keinen Körper</translation>
    </message>
    <message>
        <source>leave fewer faces out</source>
        <translation>weniger Flächen weglassen</translation>
    </message>
    <message>
        <source>the walls have {} mm3 instead of {}</source>
        <translation>die Wände haben {} mm³ statt {}</translation>
    </message>
    <message>
        <source>bodies that share a face, or lie apart</source>
        <translation>Körper, die eine Fläche gemeinsam haben oder getrennt liegen</translation>
    </message>
    <message>
        <source>nothing is left of the walls</source>
        <translation>von den Wänden bleibt nichts übrig</translation>
    </message>
    <message>
        <source>nothing is traced on the photo to fit to</source>
        <translation>auf dem Foto ist nichts nachgezeichnet, wozu es passen soll</translation>
    </message>
    <message>
        <source>only shown: to say it, draw an upright edge from the ground to there</source>
        <translation>nur angezeigt: um sie anzugeben, eine senkrechte Kante vom Boden dorthin zeichnen</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>other CAD programs</source>
        <translation>andere CAD-Programme</translation>
    </message>
    <message>
        <source>parts list</source>
        <translation>Stückliste</translation>
    </message>
    <message>
        <source>photo corner</source>
        <translation>Fotoecke</translation>
    </message>
    <message>
        <source>photo edge</source>
        <translation>Fotokante</translation>
    </message>
    <message>
        <source>plates or a shelled solid</source>
        <translation>Platten oder einen Hohlkörper</translation>
    </message>
    <message>
        <source>px down</source>
        <translation>px unten</translation>
    </message>
    <message>
        <source>px right,</source>
        <translation>px rechts,</translation>
    </message>
    <message>
        <source>revolution {} is not solved</source>
        <translation>der Drehkörper {} ist nicht gelöst</translation>
    </message>
    <message>
        <source>right-angle annotations, or split the faces</source>
        <translation>rechte Winkel angeben oder die Flächen teilen</translation>
    </message>
    <message>
        <source>right-angle annotations, so that it becomes flat</source>
        <translation>rechte Winkel angeben, damit sie eben wird</translation>
    </message>
    <message>
        <source>said to be right in the sketch</source>
        <translation>in der Skizze als rechter Winkel angegeben</translation>
    </message>
    <message>
        <source>scripts</source>
        <translation>Skripte</translation>
    </message>
    <message>
        <source>select one set of plates or one shelled solid; each goes into a file of its own</source>
        <translation>bitte einen Satz Platten oder einen Hohlkörper auswählen; jeder kommt in eine eigene Datei</translation>
    </message>
    <message>
        <source>select {} first</source>
        <translation>bitte zuerst {} auswählen</translation>
    </message>
    <message>
        <source>slicer</source>
        <translation>Slicer</translation>
    </message>
    <message>
        <source>slicer, with units</source>
        <translation>Slicer, mit Einheiten</translation>
    </message>
    <message>
        <source>solve the sketch again</source>
        <translation>die Skizze noch einmal lösen</translation>
    </message>
    <message>
        <source>stopped; recompute it to begin again</source>
        <translation>angehalten; neu berechnen, um neu zu beginnen</translation>
    </message>
    <message>
        <source>the Python package {0} is missing; install it with FreeCAD's Addon Manager, or with: {1} -m pip install --target {2} {0}</source>
        <translation>das Python-Paket {0} fehlt; bitte mit FreeCADs Addon-Manager installieren oder mit: {1} -m pip install --target {2} {0}</translation>
    </message>
    <message>
        <source>the STEP file could not be written</source>
        <translation>die STEP-Datei ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>the face has no area</source>
        <translation>die Fläche hat keinen Inhalt</translation>
    </message>
    <message>
        <source>the face has no thickness</source>
        <translation>die Fläche hat keine Dicke</translation>
    </message>
    <message>
        <source>the face is {} mm off its plane</source>
        <translation>die Fläche weicht {} mm von ihrer Ebene ab</translation>
    </message>
    <message>
        <source>the faces do not close: these edges lie open</source>
        <translation>die Flächen schließen nicht: diese Kanten liegen offen</translation>
    </message>
    <message>
        <source>the faces do not enclose anything</source>
        <translation>die Flächen umschließen nichts</translation>
    </message>
    <message>
        <source>the faces enclose no solid</source>
        <translation>die Flächen umschließen keinen Körper</translation>
    </message>
    <message>
        <source>the joint's {} is {} mm</source>
        <translation>bei der Verbindung ist {} {} mm</translation>
    </message>
    <message>
        <source>the mesh holds {} mm3 instead of {}</source>
        <translation>das Netz umschließt {} mm³ statt {}</translation>
    </message>
    <message>
        <source>the outline crosses itself</source>
        <translation>der Umriss schneidet sich selbst</translation>
    </message>
    <message>
        <source>for material outside of the face or in its middle, its outline moves by {} mm and crosses itself: an edge of {} mm would run the other way</source>
        <translation>für Material außerhalb der Fläche oder in ihrer Mitte verschiebt sich ihr Umriss um {} mm und kreuzt sich selbst: eine Kante von {} mm liefe andersherum</translation>
    </message>
    <message>
        <source>the plates would lie in one another: their faces are {} mm apart, and they are {} and {} mm thick</source>
        <translation>die Platten lägen ineinander: ihre Flächen sind {} mm voneinander entfernt, und sie sind {} und {} mm dick</translation>
    </message>
    <message>
        <source>the plates would lie in one another: {} takes {} of {}, with {} and {} mm</source>
        <translation>die Platten lägen ineinander: {} nimmt {} von {} weg, bei {} und {} mm</translation>
    </message>
    <message>
        <source>plates of {} mm cut {} into {} pieces {} mm apart</source>
        <translation>Platten von {} mm zerschneiden {} in {} Teile mit {} mm Abstand</translation>
    </message>
    <message>
        <source>plates of {} mm leave nothing of {}, {} mm wide</source>
        <translation>Platten von {} mm lassen nichts übrig von {}, {} mm breit</translation>
    </message>
    <message>
        <source>another joint at {}, or thinner plates</source>
        <translation>eine andere Verbindung bei {}, oder dünnere Platten</translation>
    </message>
    <message>
        <source>thinner plates, or more room between these faces</source>
        <translation>dünnere Platten, oder mehr Platz zwischen diesen Flächen</translation>
    </message>
    <message>
        <source>{} plates meet in one edge, and joints are of two</source>
        <translation>{} Platten treffen sich in einer Kante, und Verbindungen haben zwei</translation>
    </message>
    <message>
        <source>these faces are not flat: corners lie up to {} mm off</source>
        <translation>diese Flächen sind nicht eben: Ecken liegen bis zu {} mm daneben</translation>
    </message>
    <message>
        <source>the preset {} cannot be read: {}</source>
        <translation>die Vorgabe {} ist nicht lesbar: {}</translation>
    </message>
    <message>
        <source>the print is {} mm, larger than the printer's {} mm</source>
        <translation>der Druck misst {} mm, mehr als die {} mm des Druckers</translation>
    </message>
    <message>
        <source>the profile crosses itself or the axis</source>
        <translation>das Profil schneidet sich selbst oder die Achse</translation>
    </message>
    <message>
        <source>the sketch is not solved: {}</source>
        <translation>die Skizze ist nicht gelöst: {}</translation>
    </message>
    <message>
        <source>the surface is not closed</source>
        <translation>die Oberfläche ist nicht geschlossen</translation>
    </message>
    <message>
        <source>the surface is not closed: {}</source>
        <translation>die Oberfläche ist nicht geschlossen: {}</translation>
    </message>
    <message>
        <source>the wall of {} mm is thinner than the least wall of {} mm</source>
        <translation>die Wand von {} mm ist dünner als die Mindestwand von {} mm</translation>
    </message>
    <message>
        <source>the wall of {} mm is too thick for this profile</source>
        <translation>die Wand von {} mm ist für dieses Profil zu dick</translation>
    </message>
    <message>
        <source>the wall of {} mm is too thick: the shape measures {} mm here</source>
        <translation>die Wand von {} mm ist zu dick: die Form misst hier {} mm</translation>
    </message>
    <message>
        <source>the walls make {} solids instead of one</source>
        <translation>die Wände ergeben {} Körper statt einem</translation>
    </message>
    <message>
        <source>the {} is {} {}</source>
        <translation>{}: {} {}</translation>
    </message>
    <message>
        <source>the {} is {}, no number</source>
        <translation>{}: {} ist keine Zahl</translation>
    </message>
    <message>
        <source>the {} is {}, not {} numbers</source>
        <translation>{}: {} sind nicht {} Zahlen</translation>
    </message>
    <message>
        <source>a joint is no JointChoice</source>
        <translation>eine Verbindung ist keine JointChoice</translation>
    </message>
    <message>
        <source>{} numbers</source>
        <translation>{} Zahlen</translation>
    </message>
    <message>
        <source>there is no joint {}</source>
        <translation>es gibt keine Verbindung {}</translation>
    </message>
    <message>
        <source>there is no picture in the clipboard; copy one first</source>
        <translation>in der Zwischenablage ist kein Bild; bitte zuerst eines kopieren</translation>
    </message>
    <message>
        <source>there is no plate {0} any more</source>
        <translation>es gibt keine Platte {0} mehr</translation>
    </message>
    <message>
        <source>there is no preset {}</source>
        <translation>es gibt keine Vorgabe {}</translation>
    </message>
    <message>
        <source>these faces are a body of their own, or a hollow within the other one</source>
        <translation>diese Flächen sind ein Körper für sich oder ein Hohlraum im anderen</translation>
    </message>
    <message>
        <source>thinner plates</source>
        <translation>dünnere Platten</translation>
    </message>
    <message>
        <source>true size on paper</source>
        <translation>wahre Größe auf Papier</translation>
    </message>
    <message>
        <source>type a value or an expression</source>
        <translation>Wert oder Ausdruck eingeben</translation>
    </message>
    <message>
        <source>waits for {}</source>
        <translation>wartet auf {}</translation>
    </message>
    <message>
        <source>what lies on the ground has no height, and what is mirrored follows what is drawn: select something else</source>
        <translation>was auf dem Boden liegt, hat keine Höhe, und Gespiegeltes folgt dem Gezeichneten: bitte etwas anderes auswählen</translation>
    </message>
    <message>
        <source>{0} cannot be written as {1}; there are: {2}</source>
        <translation>{0} kann nicht als {1} geschrieben werden; es gibt: {2}</translation>
    </message>
    <message>
        <source>{0} cannot hold together with {1}: try removing {0}.</source>
        <translation>{0} kann nicht zusammen mit {1} gelten: {0} versuchsweise entfernen.</translation>
    </message>
    <message>
        <source>{0} cannot hold: try removing {0}.</source>
        <translation>{0} kann nicht gelten: {0} versuchsweise entfernen.</translation>
    </message>
    <message>
        <source>{0} is no preset: {1}</source>
        <translation>{0} ist keine Vorgabe: {1}</translation>
    </message>
    <message>
        <source>{0} plates on {1} sheets ({2}), {3:.2f} m of cuts, about {4} min</source>
        <translation>{0} Platten auf {1} Tafeln ({2}), {3:.2f} m Schnitte, etwa {4} min</translation>
    </message>
    <message>
        <source>{0} traced lines, the worst ({1}) {2:.1f} px off.</source>
        <translation>{0} nachgezeichnete Linien, die schlechteste ({1}) {2:.1f} px daneben.</translation>
    </message>
    <message>
        <source>{0}: an edge or face of {1} that it was built on is gone: choose another</source>
        <translation>{0}: eine Kante oder Fläche von {1}, auf der es beruhte, gibt es nicht mehr: bitte eine andere wählen</translation>
    </message>
    <message>
        <source>{0}: edge {1}, from {2} to {3}</source>
        <translation>{0}: Kante {1}, von {2} nach {3}</translation>
    </message>
    <message>
        <source>{:.1f} cm3 of material</source>
        <translation>{:.1f} cm3 Material</translation>
    </message>
    <message>
        <source>{} cannot all hold: take one of them away.</source>
        <translation>{} können nicht alle gelten: bitte eine davon wegnehmen.</translation>
    </message>
    <message>
        <source>{} conditions on {} coordinates are left</source>
        <translation>{} Bedingungen an {} Koordinaten bleiben</translation>
    </message>
    <message>
        <source>{} contradicts the rest: with it the drawing is missed by {} px, without it by {} px.</source>
        <translation>{} widerspricht dem Rest: damit wird die Zeichnung um {} px verfehlt, ohne um {} px.</translation>
    </message>
    <message>
        <source>{} coordinates are free</source>
        <translation>{} Koordinaten sind frei</translation>
    </message>
    <message>
        <source>{} does not meet this edge</source>
        <translation>{} trifft diese Kante nicht</translation>
    </message>
    <message>
        <source>{} drawn without width or height: pull the ellipse open.</source>
        <translation>{} ist ohne Breite oder Höhe gezeichnet: bitte die Ellipse aufziehen.</translation>
    </message>
    <message>
        <source>{} ends on {}, which must own the ends</source>
        <translation>{} endet auf {}, dem die Enden gehören müssen</translation>
    </message>
    <message>
        <source>{} freedom left: add a right angle, parallel or ground vertex at {}.</source>
        <translation>Noch {} Freiheit: bitte einen rechten Winkel, eine Parallele oder einen Bodenpunkt bei {} angeben.</translation>
    </message>
    <message>
        <source>{} freedom left: give the diameter of {}, or join circles of one axis to a surface of revolution (V).</source>
        <translation>Noch {} Freiheit: bitte den Durchmesser von {} angeben oder Kreise einer Achse zu einer Drehfläche verbinden (V).</translation>
    </message>
    <message>
        <source>{} freedom left: nothing is said to be square or parallel; begin with right angles at {}.</source>
        <translation>Noch {} Freiheit: nichts ist als rechtwinklig oder parallel angegeben; bitte mit rechten Winkeln an {} beginnen.</translation>
    </message>
    <message>
        <source>{} freedoms left: add a right angle, parallel or ground vertex at {}.</source>
        <translation>Noch {} Freiheiten: bitte einen rechten Winkel, eine Parallele oder einen Bodenpunkt bei {} angeben.</translation>
    </message>
    <message>
        <source>{} freedoms left: give the diameter of {}, or join circles of one axis to a surface of revolution (V).</source>
        <translation>Noch {} Freiheiten: bitte den Durchmesser von {} angeben oder Kreise einer Achse zu einer Drehfläche verbinden (V).</translation>
    </message>
    <message>
        <source>{} freedoms left: nothing is said to be square or parallel; begin with right angles at {}.</source>
        <translation>Noch {} Freiheiten: nichts ist als rechtwinklig oder parallel angegeben; bitte mit rechten Winkeln an {} beginnen.</translation>
    </message>
    <message>
        <source>{} had been opened or saved without this addon and had lost what makes them follow the sketch; they have it again</source>
        <translation>{} wurden ohne dieses Addon geöffnet oder gespeichert und folgten der Skizze nicht mehr; jetzt folgen sie wieder</translation>
    </message>
    <message>
        <source>{} is no joint</source>
        <translation>{} ist keine Verbindung</translation>
    </message>
    <message>
        <source>{} is not there; use the command below.</source>
        <translation>{} ist nicht vorhanden; bitte den Befehl unten verwenden.</translation>
    </message>
    <message>
        <source>{} of {} things are in the way</source>
        <translation>{} von {} Dingen sind im Weg</translation>
    </message>
    <message>
        <source>{} or a .json file</source>
        <translation>{} oder eine .json-Datei</translation>
    </message>
    <message>
        <source>{} plates</source>
        <translation>{} Platten</translation>
    </message>
    <message>
        <source>{} vertices, {} edges, {} annotations</source>
        <translation>{} Punkte, {} Kanten, {} Angaben</translation>
    </message>
    <message>
        <source>{} was saved by a newer version of this addon; what it added is left as it is</source>
        <translation>{} wurde von einer neueren Version dieses Addons gespeichert; was sie hinzufügte, bleibt, wie es ist</translation>
    </message>
    <message>
        <source>{}, too many to solve for: mark right angles and parallels.</source>
        <translation>{}, zu viele, um sie zu bestimmen: bitte rechte Winkel und Parallelen markieren.</translation>
    </message>
    <message>
        <source>{}; try: {}</source>
        <translation>{}; bitte: {}</translation>
    </message>
    <message>
        <source>Lifting the sketch to 3D ...</source>
        <translation>Skizze wird in 3D gehoben …</translation>
    </message>
    <message>
        <source>Making the plates ...</source>
        <translation>Platten werden gemacht …</translation>
    </message>
    <message>
        <source>Looking how the plates go together ...</source>
        <translation>Reihenfolge des Zusammenbaus wird gesucht …</translation>
    </message>
    <message>
        <source>Making the solid; the first time takes some seconds ...</source>
        <translation>Körper wird gemacht; das erste Mal dauert einige Sekunden …</translation>
    </message>
    <message>
        <source>Laying the plates out on sheets ...</source>
        <translation>Platten werden auf Tafeln verteilt …</translation>
    </message>
    <message>
        <source>Writing the {} file ...</source>
        <translation>Die Datei {} wird geschrieben …</translation>
    </message>
    <message>
        <source>Checking the fit ...</source>
        <translation>Passung wird geprüft …</translation>
    </message>
    <message>
        <source>Looking at the straight lines in the photo ...</source>
        <translation>Die geraden Linien im Foto werden betrachtet …</translation>
    </message>
    <message>
        <source>Straightening the photo ...</source>
        <translation>Foto wird begradigt …</translation>
    </message>
    <message>
        <source>Looking for the corners in the photo ...</source>
        <translation>Die Ecken werden im Foto gesucht …</translation>
    </message>
    <message>
        <source>{}: {} between {} and {} at {} degrees ({})</source>
        <translation>{}: {} zwischen {} und {} bei {} Grad ({})</translation>
    </message>
    <message>
        <source>{}: {} between {} and {} at {} degrees</source>
        <translation>{}: {} zwischen {} und {} bei {} Grad</translation>
    </message>
    <message>
        <source>{} between {} and {} at {} degrees ({})</source>
        <translation>{} zwischen {} und {} bei {} Grad ({})</translation>
    </message>
    <message>
        <source>{} between {} and {} at {} degrees</source>
        <translation>{} zwischen {} und {} bei {} Grad</translation>
    </message>
    <message>
        <source>finger</source>
        <translation>Zinken</translation>
    </message>
    <message>
        <source>half lap</source>
        <translation>Überblattung</translation>
    </message>
    <message>
        <source>tab slot</source>
        <translation>Zapfen und Schlitz</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine Verbindung</translation>
    </message>
    <message>
        <source>{} degrees; fingers hold from 30 to 150 degrees</source>
        <translation>{} Grad; Zinken halten von 30 bis 150 Grad</translation>
    </message>
    <message>
        <source>{} mm clear of the corners; fingers need {} mm at least</source>
        <translation>{} mm zwischen den Ecken; Zinken brauchen mindestens {} mm</translation>
    </message>
    <message>
        <source>{} and {} more: fingers of {} mm would not hold, they are {} mm wide or wider</source>
        <translation>{} und {} weitere: Zinken von {} mm würden nicht halten, sie sind {} mm breit oder breiter</translation>
    </message>
    <message>
        <source>{}: fingers of {} mm would not hold, they are {} mm wide or wider</source>
        <translation>{}: Zinken von {} mm würden nicht halten, sie sind {} mm breit oder breiter</translation>
    </message>
    <message>
        <source>fingers would cut {} into pieces</source>
        <translation>Zinken würden {} zerteilen</translation>
    </message>
    <message>
        <source>slots would be less than {} mm from a border of {}</source>
        <translation>Schlitze wären weniger als {} mm von einem Rand von {} entfernt</translation>
    </message>
    <message>
        <source>{}: the slot for {} ({}) is {} mm from a border, less than the plate's {} mm; it may break</source>
        <translation>{}: der Schlitz für {} ({}) liegt {} mm vor einem Rand, weniger als die {} mm der Platte; er kann ausbrechen</translation>
    </message>
    <message>
        <source>{}: the slot for {} is {} mm from a border, less than the plate's {} mm; it may break</source>
        <translation>{}: der Schlitz für {} liegt {} mm vor einem Rand, weniger als die {} mm der Platte; er kann ausbrechen</translation>
    </message>
    <message>
        <source>{} meet in a point: {} mm3 stay empty there, which square cuts cannot fill</source>
        <translation>{} treffen sich in einem Punkt: {} mm³ bleiben dort leer, die gerade Schnitte nicht füllen können</translation>
    </message>
    <message>
        <source>begin with {}</source>
        <translation>mit {} beginnen</translation>
    </message>
    <message>
        <source>put {} on, moving along ({}, {}, {})</source>
        <translation>{} ansetzen, in Richtung ({}, {}, {})</translation>
    </message>
    <message>
        <source>cannot be put together: {} lock each other</source>
        <translation>lässt sich nicht zusammensetzen: {} sperren einander</translation>
    </message>
    <message>
        <source>a butt joint between them</source>
        <translation>eine stumpfe Verbindung zwischen ihnen</translation>
    </message>
    <message>
        <source>finger at a corner: {} mm wide, its cut path {} mm</source>
        <translation>Zinken an einer Ecke: {} mm breit, sein Schnittweg {} mm</translation>
    </message>
    <message>
        <source>notch at a corner: {} mm wide, its cut path {} mm</source>
        <translation>Kerbe an einer Ecke: {} mm breit, ihr Schnittweg {} mm</translation>
    </message>
    <message>
        <source>tab: {} mm wide, its cut path {} mm</source>
        <translation>Zapfen: {} mm breit, sein Schnittweg {} mm</translation>
    </message>
    <message>
        <source>slot: {} x {} mm, its cut path {} x {} mm</source>
        <translation>Schlitz: {} x {} mm, sein Schnittweg {} x {} mm</translation>
    </message>
    <message>
        <source>kerf {} mm: paths lie {} mm outside of outlines and inside of holes</source>
        <translation>Schnittfuge {} mm: Wege liegen {} mm außerhalb der Umrisse und innerhalb der Löcher</translation>
    </message>
    <message>
        <source>kerf 0 mm: paths are the finished sizes; whoever cuts has to allow for the beam</source>
        <translation>Schnittfuge 0 mm: Wege haben die Fertigmaße; wer schneidet, muss den Strahl berücksichtigen</translation>
    </message>
    <message>
        <source>play {} mm: between a finger and its notch, a tab and its slot, there are {} mm on each side</source>
        <translation>Spiel {} mm: zwischen Zinken und Kerbe, Zapfen und Schlitz sind auf jeder Seite {} mm</translation>
    </message>
    <message>
        <source>{} for a cutter of {} mm: cuts {} mm beyond the sides of inner corners</source>
        <translation>{} für einen Fräser von {} mm: schneidet {} mm über die Seiten innerer Ecken hinaus</translation>
    </message>
    <message>
        <source>dog bone</source>
        <translation>Hundeknochen</translation>
    </message>
    <message>
        <source>T-bone</source>
        <translation>T-Knochen</translation>
    </message>
    <message>
        <source>it stands: its centre of mass lies {0} mm within what it stands on; it tips {1} when the ground leans by {2} degrees</source>
        <translation>es steht: der Schwerpunkt liegt {0} mm innerhalb der Standfläche; es kippt {1}, wenn sich der Boden um {2} Grad neigt</translation>
    </message>
    <message>
        <source>it stands (easily knocked over): its centre of mass lies {0} mm within what it stands on; it tips {1} when the ground leans by {2} degrees</source>
        <translation>es steht (leicht umzuwerfen): der Schwerpunkt liegt {0} mm innerhalb der Standfläche; es kippt {1}, wenn sich der Boden um {2} Grad neigt</translation>
    </message>
    <message>
        <source>it does not stand: it touches the ground in a line only, and tips {}</source>
        <translation>es steht nicht: es berührt den Boden nur in einer Linie und kippt {}</translation>
    </message>
    <message>
        <source>it does not stand: it tips {}, its centre of mass lies {} mm beyond what it stands on</source>
        <translation>es steht nicht: es kippt {}, der Schwerpunkt liegt {} mm außerhalb der Standfläche</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>to the front</source>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>nach hinten</translation>
    </message>
    <message>
        <source>nothing to fit to: trace what is there, and make it construction</source>
        <translation>nichts, wozu es passen soll: nachzeichnen, was da ist, und zu Hilfsgeometrie machen</translation>
    </message>
    <message>
        <source>{} (which will stand {} mm higher)</source>
        <translation>{} (steht dann {} mm höher)</translation>
    </message>
    <message>
        <source>{}: lies on the ground, nothing runs into it</source>
        <translation>{}: liegt auf dem Boden, nichts stößt daran</translation>
    </message>
    <message>
        <source>{}: does not fit, it reaches {}; one pixel of the photo is {} mm there</source>
        <translation>{}: passt nicht, es reicht {}; ein Pixel des Fotos ist dort {} mm</translation>
    </message>
    <message>
        <source>{}: does not fit, it reaches {}</source>
        <translation>{}: passt nicht, es reicht {}</translation>
    </message>
    <message>
        <source>{}: fits, {}; room: {}; one pixel of the photo is {} mm there</source>
        <translation>{}: passt, {}; Platz: {}; ein Pixel des Fotos ist dort {} mm</translation>
    </message>
    <message>
        <source>{}: fits, {}; one pixel of the photo is {} mm there</source>
        <translation>{}: passt, {}; ein Pixel des Fotos ist dort {} mm</translation>
    </message>
    <message>
        <source>{}: fits, {}; room: {}</source>
        <translation>{}: passt, {}; Platz: {}</translation>
    </message>
    <message>
        <source>{}: fits, {}</source>
        <translation>{}: passt, {}</translation>
    </message>
    <message>
        <source>nothing near</source>
        <translation>nichts in der Nähe</translation>
    </message>
    <message>
        <source>touches {}</source>
        <translation>berührt {}</translation>
    </message>
    <message>
        <source>{0} mm from {1}</source>
        <translation>{0} mm von {1}</translation>
    </message>
    <message>
        <source>{0} mm into {1}</source>
        <translation>{0} mm in {1} hinein</translation>
    </message>
    <message>
        <source>free {}</source>
        <translation>frei {}</translation>
    </message>
    <message>
        <source>{} mm left</source>
        <translation>{} mm links</translation>
    </message>
    <message>
        <source>{} mm right</source>
        <translation>{} mm rechts</translation>
    </message>
    <message>
        <source>{} mm front</source>
        <translation>{} mm vorn</translation>
    </message>
    <message>
        <source>{} mm back</source>
        <translation>{} mm hinten</translation>
    </message>
    <message>
        <source>{} mm up</source>
        <translation>{} mm oben</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>mark {}</source>
        <translation>Marke {}</translation>
    </message>
    <message>
        <source>block {}</source>
        <translation>Quader {}</translation>
    </message>
    <message>
        <source>surface {}</source>
        <translation>Fläche {}</translation>
    </message>
    <message>
        <source>cylinder {}</source>
        <translation>Zylinder {}</translation>
    </message>
    <message>
        <source>{} is held by glue alone ({})</source>
        <translation>{} hält nur durch Leim ({})</translation>
    </message>
    <message>
        <source>{} is held by one joint only ({}); glue it</source>
        <translation>{} hält nur an einer Verbindung ({}); bitte leimen</translation>
    </message>
    <message>
        <source>nothing joins these to one another: {}</source>
        <translation>nichts verbindet diese miteinander: {}</translation>
    </message>
    <message>
        <source>{0} is thinner than {1} mm about ({2}, {3}) mm from its corner: it breaks there</source>
        <translation>{0} ist etwa ({1}, {2}) mm von der Ecke dünner als {3} mm: dort bricht es</translation>
    </message>
    <message>
        <source>walls are thinner than the printer's line of {0} mm from {1} to {2} mm above the lowest point: they are not printed there</source>
        <translation>Wände sind {1} bis {2} mm über dem tiefsten Punkt dünner als die Linie des Druckers von {0} mm: dort werden sie nicht gedruckt</translation>
    </message>
    <message>
        <source>the photo {} lies outside the sketch's folder and is not opened</source>
        <translation>das Foto {} liegt außerhalb des Ordners der Skizze und wird nicht geöffnet</translation>
    </message>
    <message>
        <source>the photo {} is not there; it is left out</source>
        <translation>das Foto {} ist nicht da; es wird weggelassen</translation>
    </message>
    <message>
        <source>the photo {} cannot be opened: {}</source>
        <translation>das Foto {} lässt sich nicht öffnen: {}</translation>
    </message>
    <message>
        <source>the photo {} cannot be read: {}</source>
        <translation>das Foto {} lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>the photo {} has {} megapixels, more than {}</source>
        <translation>das Foto {} hat {} Megapixel, mehr als {}</translation>
    </message>
    <message>
        <source>a smaller copy of it</source>
        <translation>eine kleinere Kopie davon</translation>
    </message>
    <message>
        <source>cannot read the photo {}: {}</source>
        <translation>das Foto {} lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>save it as JPEG or PNG (read here are {})</source>
        <translation>als JPEG oder PNG speichern (lesbar sind hier {})</translation>
    </message>
    <message>
        <source>it is no picture</source>
        <translation>es ist kein Bild</translation>
    </message>
    <message>
        <source>the photo is {} x {} px, the sketch says {} x {}</source>
        <translation>das Foto hat {} x {} px, die Skizze nennt {} x {}</translation>
    </message>
    <message>
        <source>{} is {}, not an object</source>
        <translation>{} ist {}, kein Objekt</translation>
    </message>
    <message>
        <source>{} is {}, not a list</source>
        <translation>{} ist {}, keine Liste</translation>
    </message>
    <message>
        <source>{} is {}, not a number</source>
        <translation>{} ist {}, keine Zahl</translation>
    </message>
    <message>
        <source>{} is {}, not an id</source>
        <translation>{} ist {}, keine Kennung</translation>
    </message>
    <message>
        <source>{} is {}, too large</source>
        <translation>{} ist {}, zu groß</translation>
    </message>
    <message>
        <source>{} is not a rotation</source>
        <translation>{} ist keine Drehung</translation>
    </message>
    <message>
        <source>{} is not a name</source>
        <translation>{} ist kein Name</translation>
    </message>
    <message>
        <source>{} is not finite</source>
        <translation>{} ist nicht endlich</translation>
    </message>
    <message>
        <source>{} is not an id</source>
        <translation>{} ist keine Kennung</translation>
    </message>
    <message>
        <source>{} is not a list of ids</source>
        <translation>{} ist keine Liste von Kennungen</translation>
    </message>
    <message>
        <source>{} is not a line of text</source>
        <translation>{} ist keine Textzeile</translation>
    </message>
    <message>
        <source>{}: an id has 1 to {} characters</source>
        <translation>{}: eine Kennung hat 1 bis {} Zeichen</translation>
    </message>
    <message>
        <source>{}: an id has no spaces, control characters or '@'</source>
        <translation>{}: eine Kennung hat keine Leerzeichen, Steuerzeichen oder '@'</translation>
    </message>
    <message>
        <source>{} has {} entries</source>
        <translation>{} hat {} Einträge</translation>
    </message>
    <message>
        <source>{} lacks {}</source>
        <translation>{} fehlt {}</translation>
    </message>
    <message>
        <source>{} has an unknown key {}</source>
        <translation>{} hat einen unbekannten Schlüssel {}</translation>
    </message>
    <message>
        <source>version {} is newer than this program, which knows {}</source>
        <translation>Version {} ist neuer als dieses Programm, das {} kennt</translation>
    </message>
    <message>
        <source>update Modeling in Context</source>
        <translation>Modeling in Context aktualisieren</translation>
    </message>
    <message>
        <source>a short id</source>
        <translation>eine kurze Kennung</translation>
    </message>
    <message>
        <source>a short text</source>
        <translation>ein kurzer Text</translation>
    </message>
    <message>
        <source>a short text, {}</source>
        <translation>ein kurzer Text, {}</translation>
    </message>
    <message>
        <source>letters, digits</source>
        <translation>Buchstaben, Ziffern</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>true/false</source>
        <translation>true/false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a number up to {}</source>
        <translation>eine Zahl bis {}</translation>
    </message>
    <message>
        <source>a number above {}</source>
        <translation>eine Zahl über {}</translation>
    </message>
    <message>
        <source>a whole number of pixels</source>
        <translation>eine ganze Zahl von Pixeln</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>at least {} entries</source>
        <translation>mindestens {} Einträge</translation>
    </message>
    <message>
        <source>{} entries</source>
        <translation>{} Einträge</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>hinzufügen</translation>
    </message>
    <message>
        <source>add it, or name another</source>
        <translation>hinzufügen oder etwas anderes nennen</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>eines von {}</translation>
    </message>
    <message>
        <source>a file of format {}</source>
        <translation>eine Datei im Format {}</translation>
    </message>
    <message>
        <source>a version from 1 to {}</source>
        <translation>eine Version von 1 bis {}</translation>
    </message>
    <message>
        <source>three perpendicular rows of length 1</source>
        <translation>drei senkrechte Zeilen der Länge 1</translation>
    </message>
    <message>
        <source>the photo's file name, or null</source>
        <translation>der Dateiname des Fotos oder null</translation>
    </message>
    <message>
        <source>an edge and a circle share an id</source>
        <translation>eine Kante und ein Kreis haben dieselbe Kennung</translation>
    </message>
    <message>
        <source>rename one of them</source>
        <translation>eines umbenennen</translation>
    </message>
    <message>
        <source>more than {0} {1}</source>
        <translation>mehr als {0} {1}</translation>
    </message>
    <message>
        <source>a smaller sketch</source>
        <translation>eine kleinere Skizze</translation>
    </message>
    <message>
        <source>{} names a {} that is not there</source>
        <translation>{} nennt {}: das gibt es nicht</translation>
    </message>
    <message>
        <source>annotation {} names a face with mirrored corners</source>
        <translation>Angabe {} nennt eine Fläche mit gespiegelten Ecken</translation>
    </message>
    <message>
        <source>draw its corners</source>
        <translation>ihre Ecken zeichnen</translation>
    </message>
    <message>
        <source>an edge begins and ends at one vertex</source>
        <translation>eine Kante beginnt und endet am selben Punkt</translation>
    </message>
    <message>
        <source>delete it</source>
        <translation>löschen</translation>
    </message>
    <message>
        <source>two edges join the same vertices</source>
        <translation>zwei Kanten verbinden dieselben Punkte</translation>
    </message>
    <message>
        <source>delete one</source>
        <translation>eine löschen</translation>
    </message>
    <message>
        <source>face {} passes a vertex twice</source>
        <translation>Fläche {} läuft zweimal durch einen Punkt</translation>
    </message>
    <message>
        <source>split the face</source>
        <translation>die Fläche teilen</translation>
    </message>
    <message>
        <source>annotation {} names one {} twice</source>
        <translation>Angabe {} nennt {} zweimal</translation>
    </message>
    <message>
        <source>name it once</source>
        <translation>einmal nennen</translation>
    </message>
    <message>
        <source>annotation {}: edge {} does not end at {}</source>
        <translation>Angabe {}: Kante {} endet nicht bei {}</translation>
    </message>
    <message>
        <source>two edges that meet at the vertex</source>
        <translation>zwei Kanten, die sich in dem Punkt treffen</translation>
    </message>
    <message>
        <source>{} has too few vertices, or one twice</source>
        <translation>{} hat zu wenige Punkte oder einen doppelt</translation>
    </message>
    <message>
        <source>solve again</source>
        <translation>noch einmal lösen</translation>
    </message>
    <message>
        <source>{} is a folder, not a file</source>
        <translation>{} ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>a file in it, {}</source>
        <translation>eine Datei darin, {}</translation>
    </message>
    <message>
        <source>{} is larger than {} MB</source>
        <translation>{} ist größer als {} MB</translation>
    </message>
    <message>
        <source>a sketch file</source>
        <translation>eine Skizzendatei</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>save the sketch again</source>
        <translation>die Skizze noch einmal speichern</translation>
    </message>
    <message>
        <source>a key stands twice in one object</source>
        <translation>ein Schlüssel steht zweimal in einem Objekt</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>einen behalten</translation>
    </message>
    <message>
        <source>cannot read {}: {}</source>
        <translation>{} lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>den Namen prüfen</translation>
    </message>
    <message>
        <source>{} is not UTF-8 text (byte {})</source>
        <translation>{} ist kein UTF-8-Text (Byte {})</translation>
    </message>
    <message>
        <source>a sketch file, saved as UTF-8</source>
        <translation>eine Skizzendatei, als UTF-8 gespeichert</translation>
    </message>
    <message>
        <source>not JSON: {} at line {}, column {}</source>
        <translation>kein JSON: {} in Zeile {}, Spalte {}</translation>
    </message>
    <message>
        <source>not JSON: {}</source>
        <translation>kein JSON: {}</translation>
    </message>
    <message>
        <source>the whole file: this one is cut off</source>
        <translation>die ganze Datei: diese ist abgeschnitten</translation>
    </message>
    <message>
        <source>correct the text there</source>
        <translation>den Text dort berichtigen</translation>
    </message>
    <message>
        <source>ordinary numbers</source>
        <translation>gewöhnliche Zahlen</translation>
    </message>
    <message>
        <source>nested too deeply to be a sketch</source>
        <translation>zu tief verschachtelt für eine Skizze</translation>
    </message>
    <message>
        <source>there is no such element in the sketch</source>
        <translation>das gibt es in der Skizze nicht</translation>
    </message>
    <message>
        <source>edges that do not meet make no angle</source>
        <translation>Kanten, die sich nicht treffen, bilden keinen Winkel</translation>
    </message>
    <message>
        <source>two that meet</source>
        <translation>zwei, die sich treffen</translation>
    </message>
    <message>
        <source>an angle of {0} degrees between {1} and {2}</source>
        <translation>ein Winkel von {0} Grad zwischen {1} und {2}</translation>
    </message>
    <message>
        <source>nothing on the ground is known to be right below {}</source>
        <translation>von nichts am Boden ist bekannt, dass es genau unter {} liegt</translation>
    </message>
    <message>
        <source>draw an upright edge from the ground to there</source>
        <translation>eine senkrechte Kante vom Boden dorthin zeichnen</translation>
    </message>
    <message>
        <source>a {} of {} mm</source>
        <translation>{}: {} mm</translation>
    </message>
    <message>
        <source>a {} above 0</source>
        <translation>{} über 0</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>one above 0</source>
        <translation>eine über 0</translation>
    </message>
    <message>
        <source>a side of fewer than two points</source>
        <translation>eine Seite aus weniger als zwei Punkten</translation>
    </message>
    <message>
        <source>draw it from bottom to top</source>
        <translation>von unten nach oben zeichnen</translation>
    </message>
    <message>
        <source>these corners are {0} px off any rectangle of {1} x {2} mm</source>
        <translation>diese Ecken liegen {0} px neben jedem Rechteck von {1} x {2} mm</translation>
    </message>
    <message>
        <source>check the size, and click the four corners again</source>
        <translation>die Größe prüfen und die vier Ecken neu anklicken</translation>
    </message>
    <message>
        <source>a rectangle of {} x {} mm is none</source>
        <translation>ein Rechteck von {} x {} mm ist keines</translation>
    </message>
    <message>
        <source>sides above 0 mm</source>
        <translation>Seiten über 0 mm</translation>
    </message>
    <message>
        <source>a rectangle has four corners</source>
        <translation>ein Rechteck hat vier Ecken</translation>
    </message>
    <message>
        <source>click each of them once</source>
        <translation>jede einmal anklicken</translation>
    </message>
    <message>
        <source>two corners are almost in one place</source>
        <translation>zwei Ecken liegen fast am selben Ort</translation>
    </message>
    <message>
        <source>click four different corners, zoomed in</source>
        <translation>vier verschiedene Ecken anklicken, vergrößert</translation>
    </message>
    <message>
        <source>these corners are no rectangle seen in perspective</source>
        <translation>diese Ecken sind kein perspektivisch gesehenes Rechteck</translation>
    </message>
    <message>
        <source>click the four outer corners of one flat rectangle, seen less from the side</source>
        <translation>die vier äußeren Ecken eines flachen Rechtecks anklicken, weniger von der Seite gesehen</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>edge or circle</source>
        <translation>Kante oder Kreis</translation>
    </message>
    <message>
        <source>annotation {}</source>
        <translation>Angabe {}</translation>
    </message>
    <message>
        <source>edge {}</source>
        <translation>Kante {}</translation>
    </message>
    <message>
        <source>face {}</source>
        <translation>Fläche {}</translation>
    </message>
    <message>
        <source>revolution {}</source>
        <translation>Drehkörper {}</translation>
    </message>
    <message>
        <source>construction</source>
        <translation>Hilfsgeometrie</translation>
    </message>
    <message>
        <source>{} cannot be {}</source>
        <translation>{} kann nicht {} sein</translation>
    </message>
    <message>
        <source>owner {} or {}</source>
        <translation>owner {} oder {}</translation>
    </message>
    <message>
        <source>owner {}</source>
        <translation>owner {}</translation>
    </message>
    <message>
        <source>side inside, or thinner plates</source>
        <translation>Seite inside oder dünnere Platten</translation>
    </message>
    <message>
        <source>a smaller kerf, or wider fingers</source>
        <translation>eine kleinere Schnittfuge oder breitere Zinken</translation>
    </message>
    <message>
        <source>the preset {} has no layers</source>
        <translation>die Vorgabe {} hat keine Ebenen</translation>
    </message>
    <message>
        <source>the preset {} names unknown layers</source>
        <translation>die Vorgabe {} nennt unbekannte Ebenen</translation>
    </message>
    <message>
        <source>the preset {} asks for a DXF that we do not write</source>
        <translation>die Vorgabe {} verlangt ein DXF, das hier nicht geschrieben wird</translation>
    </message>
    <message>
        <source>dxf "R2000" or "R12", lines true or false</source>
        <translation>dxf "R2000" oder "R12", lines true oder false</translation>
    </message>
    <message>
        <source>the preset {} says something unknown of a layer</source>
        <translation>die Vorgabe {} sagt Unbekanntes über eine Ebene</translation>
    </message>
    <message>
        <source>the preset {} has a wrong name or colour</source>
        <translation>die Vorgabe {} hat einen falschen Namen oder eine falsche Farbe</translation>
    </message>
    <message>
        <source>a name, aci from 1 to 255, rgb like #ff0000</source>
        <translation>ein Name, aci von 1 bis 255, rgb wie #ff0000</translation>
    </message>
    <message>
        <source>these faces do not stand at right angles to the others</source>
        <translation>diese Flächen stehen nicht senkrecht auf den anderen</translation>
    </message>
    <message>
        <source>right-angle annotations</source>
        <translation>Angaben von rechten Winkeln</translation>
    </message>
    <message>
        <source>a surface of revolution has no flat face to make a plate of</source>
        <translation>eine Drehfläche hat keine ebene Fläche für eine Platte</translation>
    </message>
    <message>
        <source>a print: a shelled solid, --print</source>
        <translation>ein Druck: ein Hohlkörper, --print</translation>
    </message>
    <message>
        <source>there is no {} {}</source>
        <translation>{} {} gibt es nicht</translation>
    </message>
    <message>
        <source>Finding the camera ...</source>
        <translation>Kamera wird gesucht …</translation>
    </message>
    <message>
        <source>Method: {}</source>
        <translation>Verfahren: {}</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Verfahren ändern</translation>
    </message>
    <message>
        <source>nothing is drawn yet</source>
        <translation>noch ist nichts gezeichnet</translation>
    </message>
    <message>
        <source>where these {0} faces meet in {1}, material cannot lie outside of them or in their middle: their planes, moved, meet in no point</source>
        <translation>wo sich diese {0} Flächen in {1} treffen, kann kein Material außerhalb oder in ihrer Mitte liegen: ihre Ebenen treffen sich verschoben in keinem Punkt</translation>
    </message>
    <message>
        <source>side inside, or one thickness for all of them</source>
        <translation>Seite inside oder eine Dicke für alle</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Whole photo</source>
        <translation>Ganzes Foto</translation>
    </message>
    <message>
        <source>Click the next end, or type how long the last line is; right click stops</source>
        <translation>Nächstes Ende anklicken oder die Länge der letzten Linie eingeben; Rechtsklick beendet</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>E&amp;xamples</source>
        <translation>&amp;Beispiele</translation>
    </message>
    <message>
        <source>Modeling in &amp;Context</source>
        <translation>Modeling in &amp;Context</translation>
    </message>
    <message>
        <source>Modeling in Context</source>
        <translation>Modeling in Context</translation>
    </message>
    <message>
        <source>Sketch &amp;tools</source>
        <translation>Skizzen&amp;werkzeuge</translation>
    </message>
    <message>
        <source>Sketch tools</source>
        <translation>Skizzenwerkzeuge</translation>
    </message>
</context>
</TS>
