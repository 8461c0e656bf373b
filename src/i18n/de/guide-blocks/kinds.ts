/** What each kind of block does, the rule of the control for it, and what is often done wrong with it. */
export const blockKinds = {
  begin: {
    about: "Der erste Satz: Name und Einheit des Programms.",
    rule: "Der Name ist der der Datei.",
    mistakes: ["Die Datei ist umbenannt, der Satz trägt noch den alten Namen."],
  },
  end: {
    about: "Der letzte Satz. Was dahinter steht, läuft nicht.",
    rule: "Name und Einheit wie in BEGIN PGM.",
    mistakes: ["M30 fehlt: Spindel und Kühlmittel bleiben am Ende an."],
  },
  blankBox: {
    about:
      "Ein Quader als Rohteil, durch seine kleinste Ecke (0.1) und seine größte (0.2). Wird er gedreht, " +
      "gilt der Zylinder um seine Ecken.",
    rule: "0.1 nennt die Spindelachse; 0.2 hat in jeder Achse den größeren Wert.",
    mistakes: ["Die Ecken sind vertauscht: Der Quader hat keinen Inhalt."],
  },
  blankCylinder: {
    about:
      "Die Stange oder Scheibe, die gedreht wird: ⌀ oder Radius, Länge, Abstand der Planfläche von Z0 und eine Bohrung.",
    rule: "Das Rohteil dient allein der Simulation; die Maschine kennt es nicht.",
    mistakes: ["Das Rohteil ist kleiner als das wirkliche: Im Bild ist Luft, wo die Maschine schneidet."],
  },
  blankRotation: {
    about: "Ein geschmiedetes oder gegossenes Rohteil: eine Kontur, die um die Achse gedreht wird.",
    rule: "Die Kontur steht hinter einem Label oder in einer Datei und zählt, wie es DIM sagt.",
    mistakes: ["Die Kontur kommt nicht zur Achse zurück: Niemand weiß, wo das Material endet."],
  },
  blankFile: {
    about: "Ein Rohteil als Körper in einer Datei, STL. Es bleibt erhalten und wird hier nicht simuliert.",
    rule: "Die Datei liegt neben dem Programm; TARGET nennt das Fertigteil.",
    mistakes: ["Die Datei wird mit dem Programm nicht mitgenommen."],
  },
  toolDefinition: {
    about: "Ältere Art, Länge und Radius eines Werkzeugs im Programm selbst zu nennen.",
    rule: "Steht das Werkzeug in der Tabelle, stellt TOOL DEF mit der Nummer allein es im Wechsler bereit.",
    mistakes: ["Es wird für Drehwerkzeuge benutzt: Diese brauchen die Drehwerkzeugtabelle."],
  },
  toolCall: {
    about:
      "Wechselt das Werkzeug, oder ändert ohne Werkzeug nur Drehzahl, Vorschub oder Aufmaße. Danach weiß " +
      "niemand, wo die Spitze steht, bis sie positioniert ist.",
    rule: "Er beendet die Werte von FUNCTION TURNDATA CORR und die Radiuskorrektur.",
    mistakes: ["Der erste Satz dahinter nennt nur eine Achse: Die andere kommt von irgendwo."],
  },
  mode: {
    about: "Wechselt zwischen Drehen und Fräsen. Beim Drehen ist X ein ⌀, und es dreht die Spindel des Teils.",
    rule: "MODE TURN vor dem ersten Drehsatz; die Maschine kann nach ihrer Kinematik fragen.",
    mistakes: ["Er fehlt: X zählt als Radius, und Drehzyklen werden abgelehnt."],
  },
  spin: {
    about: "Wie schnell das Teil dreht: konstante Schnittgeschwindigkeit mit Grenze, oder eine feste Drehzahl.",
    rule: "Er gilt bis zum nächsten. Er startet die Spindel nicht: Das tut M3 oder M4.",
    mistakes: ["Er steht hinter dem ersten Schnitt."],
  },
  turnCorrection: {
    about: "Macht das Werkzeug im Programm länger oder kürzer: Ein Maß wird ohne die Tabelle korrigiert.",
    rule: "Er gilt bis zum nächsten TOOL CALL.",
    mistakes: ["Das Vorzeichen ist verwechselt: Mehr DXL macht einen Außendurchmesser größer."],
  },
  turnBlank: {
    about:
      "Rohteilnachführung: Die Steuerung merkt sich, was geschnitten ist, damit kein Zyklus noch einmal Luft schneidet.",
    rule: "An zwischen BLANK und BLANK OFF; der Umriss muss geschlossen sein.",
    mistakes: ["Sie bleibt für die zweite Spannung an: Das alte Rohteil gilt noch."],
  },
  L: {
    about: "Gerade zu einem Punkt. Achsen, die fehlen, bleiben stehen.",
    rule: "Vorschub, Korrektur und M-Funktionen gelten weiter.",
    mistakes: ["Ein Vorzeichen fehlt: Z25 liegt vor dem Teil."],
  },
  LP: {
    about: "Gerade zu einem Punkt durch Abstand und Winkel vom Pol CC.",
    rule: "Ein CC-Satz steht davor.",
    mistakes: ["Dazwischen steht ein anderer CC: Der Punkt liegt woanders."],
  },
  C: {
    about: "Bogen um den Mittelpunkt CC bis zu seinem Endpunkt.",
    rule: "Start und Ende liegen auf einem Kreis um CC.",
    mistakes: ["Der Endpunkt liegt nicht auf dem Kreis: Die Steuerung hält mit Fehler an."],
  },
  CP: {
    about: "Bogen um CC bis zu einem Winkel.",
    rule: "Der Radius ist der Abstand vom Start zu CC.",
    mistakes: ["DR fehlt: Der Bogen läuft andersherum."],
  },
  CR: {
    about: "Bogen zu einem Punkt durch seinen Radius.",
    rule: "Vier Bögen passen: Das Vorzeichen von R und DR wählen einen davon.",
    mistakes: ["Der Radius ist kleiner als der halbe Weg: Es gibt keinen solchen Bogen."],
  },
  CT: {
    about: "Bogen, der ohne Ecke an das Element davor anschließt.",
    rule: "Zwei Koordinaten, und ein Element davor.",
    mistakes: ["Er steht hinter einer Ecke, die bleiben sollte."],
  },
  CTP: {
    about: "Tangentialer Bogen zu einem Punkt, der vom Pol CC aus gegeben ist.",
    rule: "CC ist hier kein Mittelpunkt; von ihm wird gemessen.",
    mistakes: ["Der Pol wird für den Mittelpunkt des Bogens gehalten."],
  },
  CC: {
    about: "Mittelpunkt von C und CP, Pol aller polaren Sätze.",
    rule: "Er bewegt nichts und gilt bis zum nächsten CC.",
    mistakes: ["X ist beim Drehen als Radius getippt; es ist ein ⌀."],
  },
  RND: {
    about: "Rundet die Ecke zwischen dem Satz davor und dem dahinter, ohne eigenen Endpunkt.",
    rule: "Er steht zwischen zwei Bahnsätzen der Ebene.",
    mistakes: ["Der Satz dahinter ist zu kurz für den Radius."],
  },
  chamfer: {
    about: "Bricht die Ecke zwischen zwei Geraden auf beiden Seiten um dieselbe Länge.",
    rule: "Er steht zwischen zwei Geraden.",
    mistakes: ["Die Länge der Schräge ist getippt; gemeint ist die Länge entlang der Kante."],
  },
  free: {
    about: "Ein Element einer freien Kontur: so viel, wie die Zeichnung gibt. Es bleibt erhalten und läuft hier nicht.",
    rule: "Die Steuerung rechnet die fehlenden Werte aus allen Elementen zusammen aus.",
    mistakes: ["Keines der Elemente ist genug bestimmt: keine Lösung."],
  },
  undercut: {
    about: "Ein genormter Freistich zwischen Zylinder und Planfläche. Wörter, die fehlen, kommen aus der Norm.",
    rule: "Er steht in der Kontur eines Zyklus zwischen den zwei Elementen.",
    mistakes: ["Er steht im Hauptprogramm: Dort tut er nichts."],
  },
  groove: {
    about: "Ein Einstich in der Geraden davor.",
    rule: "Er steht in der Kontur eines Zyklus.",
    mistakes: ["Er ist breiter, als sein Element Platz hat."],
  },
  label: {
    about:
      "Eine Stelle, die gerufen werden kann: Unterprogramm, Wiederholung, Kontur. LBL 0 beendet ein Unterprogramm.",
    rule: "Jede Nummer und jeder Name einmal im Programm.",
    mistakes: ["Das Unterprogramm steht vor M30: Es läuft von selbst noch einmal."],
  },
  call: {
    about: "Lässt laufen, was hinter einem Label steht, einmal oder mehrmals.",
    rule: "Ohne REP bis LBL 0; mit REP noch einmal den Teil davor.",
    mistakes: ["REP zählt die Wiederholungen: Mit 3 läuft der Teil viermal."],
  },
  jump: {
    about: "Geht bei einem Label weiter, wenn ein Vergleich zutrifft.",
    rule: "Auf beiden Seiten können Zahlen oder Parameter stehen.",
    mistakes: ["In der Schleife ändert nichts den Parameter: Sie endet nie."],
  },
  raise: {
    about: "Hält das Programm mit einem Fehler dieser Nummer an.",
    rule: "Welcher Text dazu gehört, sagt der Maschinenhersteller.",
    mistakes: ["Er steht, wo jeder Lauf vorbeikommt."],
  },
  contour: {
    about: "Nennt die Label, deren Kontur der nächste Zyklus dreht.",
    rule: "Mehrere Label hintereinander sind eine Liste.",
    mistakes: ["Das Label fehlt oder steht in einer anderen Datei."],
  },
  cycleLine: {
    about: "Eine Zeile eines älteren Zyklus. Seine erste Zeile hat .0.",
    rule: "Die Zeilen eines Zyklus stehen hintereinander.",
    mistakes: ["Eine Zeile dazwischen ist gelöscht: Der Zyklus liest die nächste an ihrer Stelle."],
  },
  cycle: {
    about: "Ein Zyklus, der hier erhalten bleibt und nicht läuft: Seine Werte bleiben, wie sie sind.",
    rule: "Er wirkt, wo er gerufen wird, oder wo er steht.",
    mistakes: ["Seine Wirkung gilt als geprüft: Ab hier sagt der Bericht, dass sie es nicht ist."],
  },
  cycleCall: {
    about: "Lässt den zuletzt definierten Zyklus laufen, von dort, wo das Werkzeug steht.",
    rule: "M99 in einem Positioniersatz tut dasselbe; M89 tut es in jedem Satz bis M99.",
    mistakes: ["Das Werkzeug steht beim Aufruf im Material."],
  },
  selectContour: {
    about: "Holt die Kontur des nächsten Zyklus aus einer Datei.",
    rule: "Die Datei liegt neben dem Programm.",
    mistakes: ["Am Namen fehlt die Endung."],
  },
  contourDefinition: {
    about: "Flächen, Inseln und Aussparungen einer Kontur in einem Satz.",
    rule: "P ist eine Fläche, I eine Insel, V eine Aussparung.",
    mistakes: ["Eine Insel steht vor der Fläche, in der sie liegt."],
  },
  declareContour: {
    about: "Gibt einer Kontur einen Namen für eine Konturformel.",
    rule: "Er kommt unverändert zurück und läuft hier nicht.",
    mistakes: ["Der Name ist zweimal vergeben."],
  },
  contourFormula: {
    about: "Verknüpft benannte Konturen: vereint, geschnitten, ohne.",
    rule: "Er kommt unverändert zurück und läuft hier nicht.",
    mistakes: ["Klammern fehlen: Die Zeichen zählen von links."],
  },
  callProgram: {
    about: "Lässt an dieser Stelle ein anderes Programm laufen.",
    rule: "Hinter dessen END PGM geht dieses Programm weiter.",
    mistakes: ["M30 im gerufenen Programm beendet alles."],
  },
  selectProgram: {
    about: "Nennt das Programm, das CALL SELECTED PGM laufen lässt.",
    rule: "Der Name kann in einem QS-Parameter stehen.",
    mistakes: ["Dazwischen wird ein anderes gewählt: Dieses gilt."],
  },
  callSelected: {
    about: "Lässt das zuletzt gewählte Programm laufen.",
    rule: "Ein SEL PGM steht davor.",
    mistakes: ["Es war nichts gewählt."],
  },
  datum: {
    about: "Verschiebt den Nullpunkt: Was folgt, zählt von dort.",
    rule: "Sie gilt bis zur nächsten; RESET nimmt sie zurück.",
    mistakes: ["Sie ist in der zweiten Hälfte des Programms noch an."],
  },
  datumTable: {
    about: "Verschiebt den Nullpunkt um eine Zeile einer Tabelle. Was darin steht, weiß hier niemand.",
    rule: "Die Tabelle muss gewählt sein.",
    mistakes: ["An der Maschine ist eine andere Tabelle aktiv."],
  },
  mirror: {
    about: "Spiegelt die Koordinaten gefräster Sätze.",
    rule: "RESET, oder keine Achse, beendet es.",
    mistakes: ["Aus Gleichlauf wird Gegenlauf."],
  },
  rotation: {
    about: "Dreht die Ebene gefräster Sätze um den Nullpunkt.",
    rule: "RESET beendet es.",
    mistakes: ["Der Pol dreht sich mit."],
  },
  scale: {
    about: "Macht gefräste Koordinaten größer oder kleiner.",
    rule: "RESET beendet es.",
    mistakes: ["Prozent sind getippt: 99 macht es 99-mal so groß."],
  },
  plane: {
    about: "Schwenkt die Bearbeitungsebene, oder setzt sie zurück. Geschwenktes läuft hier nicht.",
    rule: "MOVE, TURN oder STAY sagen, was die Achsen tun.",
    mistakes: ["Sie ist vor dem Drehen nicht zurückgesetzt."],
  },
  assign: {
    about: "Gibt einem Q-Parameter einen Wert, oder rechnet ihn aus.",
    rule: "Q gilt in allen Programmen, QL in seinem eigenen, QR bleibt nach dem Ausschalten.",
    mistakes: ["Den Parameter benutzt ein Zyklus selbst."],
  },
  assignText: {
    about: "Legt Text in einen QS-Parameter.",
    rule: "Teile werden mit || verbunden.",
    mistakes: ["Die Anführungszeichen fehlen."],
  },
  functions: {
    about: "M-Funktionen ohne Weg: Spindel, Kühlmittel, Einheit des Vorschubs.",
    rule: "Manche wirken vor der Bewegung ihres Satzes, manche danach.",
    mistakes: ["M136 fehlt vor dem ersten Vorschub je Umdrehung."],
  },
  stop: {
    about: "Hält an, bis NC-Start gedrückt wird.",
    rule: "Spindel und Kühlmittel bleiben an, wenn keine M-Funktion es anders sagt.",
    mistakes: ["Er steht im Schnitt: Die Schneide reibt auf einer Stelle."],
  },
  comment: {
    about: "Worte für den, der das Programm liest.",
    rule: "Sie ändern nichts.",
    mistakes: ["Ein Kommentar nennt Werte, die inzwischen geändert sind."],
  },
  structure: {
    about: "Eine Überschrift in der Liste der Programmteile.",
    rule: "Die Gliederung der Steuerung zeigt sie.",
    mistakes: ["Teile werden verschoben, ihre Überschriften bleiben."],
  },
};
