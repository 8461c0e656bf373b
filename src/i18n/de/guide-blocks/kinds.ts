/** Function of each kind of block, the rule of the control, and common mistakes. */
export const blockKinds = {
  begin: {
    about: "Der erste Satz: Name und Einheit des Programms.",
    rule: "Programmname und Dateiname müssen gleich sein.",
    mistakes: ["Datei umbenannt, der Satz enthält noch den alten Namen."],
  },
  end: {
    about: "Der letzte Satz. Spätere Sätze werden nicht ausgeführt.",
    rule: "Name und Einheit wie in BEGIN PGM.",
    mistakes: ["M30 fehlt: Spindel und Kühlmittel bleiben am Ende ein."],
  },
  blankBox: {
    about:
      "Quader als Rohteil, definiert durch MIN-Punkt (0.1) und MAX-Punkt (0.2). Beim Drehen gilt der Zylinder um " +
      "seine Ecken.",
    rule: "0.1 enthält die Spindelachse; 0.2 hat in jeder Achse den größeren Wert.",
    mistakes: ["MIN- und MAX-Punkt vertauscht: Der Quader hat kein Volumen."],
  },
  blankCylinder: {
    about: "Zylinder als Rohteil: ⌀ oder Radius, Länge, Abstand der Planfläche von Z0 und Bohrung.",
    rule: "Das Rohteil dient nur der Simulation.",
    mistakes: ["Rohteil kleiner als das tatsächliche: Die Simulation zeigt Luft, wo die Maschine schneidet."],
  },
  blankRotation: {
    about: "Geschmiedetes oder gegossenes Rohteil: eine um die Achse rotierte Kontur.",
    rule: "Die Kontur ist in einem Label oder einer Datei; DIM legt Durchmesser- oder Radiuswerte fest.",
    mistakes: ["Die Kontur führt nicht zur Achse zurück: Das Ende des Materials ist nicht definiert."],
  },
  blankFile: {
    about: "Rohteil aus einer STL-Datei. Bleibt erhalten, wird nicht simuliert.",
    rule: "Die Datei liegt im Ordner des Programms; TARGET wählt das Fertigteil.",
    mistakes: ["Die Datei wird nicht mit dem Programm exportiert."],
  },
  toolDefinition: {
    about: "Ältere Definition von Werkzeuglänge und -radius im Programm.",
    rule: "Ist das Werkzeug in der Tabelle, stellt TOOL DEF nur mit der Nummer das Werkzeug im Wechsler bereit.",
    mistakes: ["Für Drehwerkzeuge verwendet: Diese benötigen die Drehwerkzeugtabelle."],
  },
  toolCall: {
    about:
      "Wechselt das Werkzeug; ohne Werkzeug ändern sich nur Drehzahl, Vorschub oder Aufmaße. Danach ist die " +
      "Position der Schneidenspitze bis zum nächsten Positionieren nicht bekannt.",
    rule: "TOOL CALL hebt FUNCTION TURNDATA CORR und die Radiuskorrektur auf.",
    mistakes: ["Der erste Satz danach enthält nur eine Achse: Die andere Position ist undefiniert."],
  },
  mode: {
    about: "Wechselt zwischen Drehen und Fräsen. Beim Drehen ist X ein ⌀, und die Drehspindel ist aktiv.",
    rule: "MODE TURN vor dem ersten Drehsatz; die Maschine kann einen Kinematiknamen verlangen.",
    mistakes: ["Der Satz fehlt: X ist ein Radius, Drehzyklen werden abgelehnt."],
  },
  spin: {
    about: "Drehzahl der Drehspindel: konstante Schnittgeschwindigkeit mit Begrenzung oder feste Drehzahl.",
    rule: "Gilt bis zum nächsten SPIN-Satz. Startet die Spindel nicht: M3 oder M4 programmieren.",
    mistakes: ["Der Satz steht nach dem ersten Schnitt."],
  },
  turnCorrection: {
    about: "Korrigiert die Werkzeuglänge im Programm, ohne Werkzeugtabelle.",
    rule: "Gilt bis zum nächsten TOOL CALL.",
    mistakes: ["Falsches Vorzeichen: Größeres DXL macht einen Außendurchmesser größer."],
  },
  turnBlank: {
    about: "Rohteilnachführung: Die Steuerung erfasst das abgetragene Material, damit Zyklen Luftschnitte vermeiden.",
    rule: "Aktiv zwischen BLANK und BLANK OFF; der Umriss muss geschlossen sein.",
    mistakes: ["Bei der zweiten Aufspannung noch aktiv: Das alte Rohteil gilt weiter."],
  },
  L: {
    about: "Gerade zu einem Punkt. Fehlende Achsen fahren nicht.",
    rule: "Vorschub, Korrektur und M-Funktionen wirken modal.",
    mistakes: ["Das Vorzeichen fehlt: Z25 liegt vor dem Teil."],
  },
  LP: {
    about: "Gerade zu einem Punkt mit Abstand und Winkel vom Pol CC.",
    rule: "Benötigt einen CC-Satz davor.",
    mistakes: ["Ein anderer CC dazwischen: Der Punkt ändert sich."],
  },
  C: {
    about: "Kreisbahn um den Mittelpunkt CC zum Endpunkt.",
    rule: "Start und Ende liegen auf einem Kreis um CC.",
    mistakes: ["Der Endpunkt liegt nicht auf dem Kreis: Die Steuerung stoppt mit einem Fehler."],
  },
  CP: {
    about: "Kreisbahn um CC bis zu einem Winkel.",
    rule: "Der Radius ist der Abstand vom Start zu CC.",
    mistakes: ["DR fehlt: Die Kreisbahn läuft in die andere Richtung."],
  },
  CR: {
    about: "Kreisbahn mit festgelegtem Radius zu einem Punkt.",
    rule: "Vier Kreisbögen sind möglich: Vorzeichen von R und DR wählen einen.",
    mistakes: ["Radius kleiner als der halbe Abstand: kein Kreisbogen möglich."],
  },
  CT: {
    about: "Kreisbahn mit tangentialem Anschluss an das vorige Element.",
    rule: "Benötigt zwei Koordinaten und ein Element davor.",
    mistakes: ["Nach einer Ecke verwendet, die bleiben soll."],
  },
  CTP: {
    about: "Kreisbahn mit tangentialem Anschluss zu einem Punkt, bezogen auf den Pol CC.",
    rule: "CC ist hier kein Mittelpunkt, sondern Bezugspunkt.",
    mistakes: ["Der Pol wird für den Kreismittelpunkt gehalten."],
  },
  CC: {
    about: "Mittelpunkt von C und CP, Pol aller polaren Sätze.",
    rule: "Keine Bewegung; gilt bis zum nächsten CC.",
    mistakes: ["X beim Drehen als Radius eingegeben; es ist ein ⌀."],
  },
  RND: {
    about: "Rundet die Ecke zwischen vorigem und nächstem Satz, ohne Endpunkt.",
    rule: "Nur zwischen zwei Bahnsätzen der Ebene.",
    mistakes: ["Der nächste Satz ist zu kurz für den Radius."],
  },
  chamfer: {
    about: "Fase zwischen zwei Geraden, auf beiden Seiten gleich lang.",
    rule: "Nur zwischen zwei Geraden.",
    mistakes: ["Länge der Schräge eingegeben; gefragt ist die Länge entlang der Kante."],
  },
  free: {
    about: "Element einer freien Kontur mit den Angaben der Zeichnung. Bleibt erhalten, wird nicht simuliert.",
    rule: "Die Steuerung berechnet die fehlenden Werte aus allen Elementen.",
    mistakes: ["Zu wenige Angaben: keine Lösung."],
  },
  undercut: {
    about: "Genormter Freistich zwischen Zylinder und Planfläche. Fehlende Wörter erhalten die Werte der Norm.",
    rule: "Nur in der Kontur eines Zyklus, zwischen den zwei Elementen.",
    mistakes: ["Im Hauptprogramm programmiert: dort ohne Wirkung."],
  },
  groove: {
    about: "Einstich in der vorigen Geraden.",
    rule: "Nur in der Kontur eines Zyklus.",
    mistakes: ["Der Einstich ist breiter als das Element."],
  },
  label: {
    about: "Beginn von Unterprogramm, Programmteil-Wiederholung oder Kontur. LBL 0 beendet ein Unterprogramm.",
    rule: "Jede Nummer und jeder Name nur einmal im Programm.",
    mistakes: ["Unterprogramm vor M30: Es läuft ohne Aufruf noch einmal."],
  },
  call: {
    about: "Führt die Sätze nach einem Label aus, einmal oder mehrmals.",
    rule: "Ohne REP: bis LBL 0. Mit REP: Programmteil wiederholen.",
    mistakes: ["REP ist die Zahl der Wiederholungen: Mit 3 läuft der Teil viermal."],
  },
  jump: {
    about: "Springt zu einem Label, wenn eine Bedingung erfüllt ist.",
    rule: "Auf beiden Seiten können Zahlen oder Parameter stehen.",
    mistakes: ["In der Schleife ändert nichts den Parameter: Sie endet nie."],
  },
  raise: {
    about: "Stoppt das Programm mit dieser Fehlernummer.",
    rule: "Den Text definiert der Maschinenhersteller.",
    mistakes: ["Programmiert, wo jeder Lauf vorbeikommt."],
  },
  contour: {
    about: "Wählt die Label mit der Kontur für den nächsten Zyklus.",
    rule: "Mehrere Label nacheinander bilden eine Liste.",
    mistakes: ["Das Label fehlt oder steht in einer anderen Datei."],
  },
  cycleLine: {
    about: "Eine Zeile eines älteren Zyklus. Seine erste Zeile hat .0.",
    rule: "Die Zeilen eines Zyklus müssen aufeinanderfolgen.",
    mistakes: ["Eine Zeile gelöscht: Der Zyklus liest stattdessen die nächste."],
  },
  cycle: {
    about: "Ein Zyklus, der erhalten bleibt, aber nicht simuliert wird: Seine Werte ändern sich nicht.",
    rule: "Wirkt beim Aufruf oder ab seiner Definition.",
    mistakes: ["Seine Wirkung wird für geprüft gehalten: Ab hier ist das Programm nicht geprüft."],
  },
  cycleCall: {
    about: "Führt den zuletzt definierten Zyklus ab der aktuellen Werkzeugposition aus.",
    rule: "M99 in einem Positioniersatz wirkt ebenso; M89 ruft in jedem Satz auf, bis M99.",
    mistakes: ["Das Werkzeug steht beim Aufruf im Material."],
  },
  selectContour: {
    about: "Wählt eine Datei mit der Kontur des nächsten Zyklus.",
    rule: "Die Datei liegt im Ordner des Programms.",
    mistakes: ["Die Dateiendung fehlt."],
  },
  contourDefinition: {
    about: "Flächen, Inseln und Aussparungen einer Kontur in einem Satz.",
    rule: "P ist eine Fläche, I eine Insel, V eine Aussparung.",
    mistakes: ["Eine Insel steht vor ihrer Fläche."],
  },
  declareContour: {
    about: "Gibt einer Kontur einen Namen für eine Konturformel.",
    rule: "Bleibt unverändert, wird nicht simuliert.",
    mistakes: ["Der Name ist doppelt vergeben."],
  },
  contourFormula: {
    about: "Verknüpft benannte Konturen: Vereinigung, Schnitt, Differenz.",
    rule: "Bleibt unverändert, wird nicht simuliert.",
    mistakes: ["Klammern fehlen: Die Operatoren gelten von links nach rechts."],
  },
  callProgram: {
    about: "Führt hier ein anderes Programm aus.",
    rule: "Nach dessen END PGM läuft dieses Programm weiter.",
    mistakes: ["M30 im aufgerufenen Programm beendet alles."],
  },
  selectProgram: {
    about: "Wählt das Programm für CALL SELECTED PGM.",
    rule: "Der Name kann ein QS-Parameter sein.",
    mistakes: ["Dazwischen ein anderes gewählt: Dieses gilt."],
  },
  callSelected: {
    about: "Führt das zuletzt gewählte Programm aus.",
    rule: "Benötigt SEL PGM davor.",
    mistakes: ["Kein Programm gewählt."],
  },
  datum: {
    about: "Nullpunktverschiebung: Die folgenden Koordinaten beziehen sich auf den neuen Nullpunkt.",
    rule: "Gilt bis zur nächsten Verschiebung; RESET hebt sie auf.",
    mistakes: ["In der zweiten Hälfte des Programms noch aktiv."],
  },
  datumTable: {
    about: "Nullpunktverschiebung mit einer Zeile der Nullpunkttabelle. Die Tabelle ist hier nicht bekannt.",
    rule: "Die Tabelle muss gewählt sein.",
    mistakes: ["An der Maschine ist eine andere Tabelle aktiv."],
  },
  mirror: {
    about: "Spiegelt die Koordinaten gefräster Sätze.",
    rule: "RESET oder keine Achse hebt die Spiegelung auf.",
    mistakes: ["Aus Gleichlauf wird Gegenlauf."],
  },
  rotation: {
    about: "Dreht die Ebene gefräster Sätze um den Nullpunkt.",
    rule: "RESET hebt sie auf.",
    mistakes: ["Der Pol dreht sich mit."],
  },
  scale: {
    about: "Skaliert gefräste Koordinaten.",
    rule: "RESET hebt sie auf.",
    mistakes: ["Prozentwert eingegeben: 99 vergrößert 99-fach."],
  },
  plane: {
    about: "Schwenkt die Bearbeitungsebene oder setzt sie zurück. Geschwenkte Bearbeitung wird nicht simuliert.",
    rule: "MOVE, TURN oder STAY legen die Achsbewegung fest.",
    mistakes: ["Vor dem Drehen nicht zurückgesetzt."],
  },
  assign: {
    about: "Weist einem Q-Parameter einen Wert zu oder berechnet ihn.",
    rule: "Q gilt in allen Programmen, QL lokal, QR bleibt nach dem Ausschalten.",
    mistakes: ["Ein Zyklus verwendet diesen Parameter."],
  },
  assignText: {
    about: "Weist einem QS-Parameter Text zu.",
    rule: "Teile werden mit || verbunden.",
    mistakes: ["Die Anführungszeichen fehlen."],
  },
  functions: {
    about: "M-Funktionen ohne Bewegung: Spindel, Kühlmittel, Einheit des Vorschubs.",
    rule: "Manche wirken vor der Bewegung ihres Satzes, manche danach.",
    mistakes: ["M136 fehlt vor dem ersten Vorschub pro Umdrehung."],
  },
  stop: {
    about: "Programmlauf-Halt bis NC-Start.",
    rule: "Spindel und Kühlmittel bleiben ein, sofern keine M-Funktion sie ändert.",
    mistakes: ["Im Schnitt programmiert: Die Schneide reibt an einer Stelle."],
  },
  comment: {
    about: "Text für den Leser des Programms.",
    rule: "Ohne Wirkung auf die Bearbeitung.",
    mistakes: ["Der Kommentar enthält veraltete Werte."],
  },
  structure: {
    about: "Gliederungspunkt des Programms.",
    rule: "Die Gliederung der Steuerung zeigt sie.",
    mistakes: ["Sätze ohne ihren Gliederungspunkt verschoben."],
  },
};
