import type { StartTexts } from "../../en/first/start.ts";

export const start = {
  hint: "Tippen sucht überall auf dieser Seite, z. B. 812. In allen vier Sprachen.",
  doors: {
    title: "Einstieg",
    guide: "Hilfe",
    glossary: "Glossar",
    program: "Zyklus programmieren",
    programHow: "Eingaben wie an der Steuerung; die Drehmaschine zeigt jeden Wert",
    openHow: "Klartext oder DIN/ISO: prüfen, im Dialog ändern, exportieren",
    plan: "Arbeitsplan vom Fertigteil",
  },
  hero: {
    name: (n) => `Eine Welle wird in ${n} Bearbeitungen gedreht: Das Werkzeug fährt und trägt Material ab`,
    play: "Abspielen",
    pause: "Anhalten",
    finish: "Schlichten",
    position: "Positionieren",
    proved: "geprüft",
    open: "Dieses Programm öffnen",
    pass: (n, of) => `Schnitt ${n} von ${of}`,
    facts: (operations, tools) => `${operations} Bearbeitungen · ${tools} Werkzeuge`,
  },
  beyond: "Mehr als die Steuerung",
  beyondAll: {
    values: {
      what: "Drei Werte nebeneinander",
      how: "eine Eingabe mit kleinem, üblichem und großem Wert, alle simuliert",
    },
    steps: { what: "Schritt für Schritt", how: "jeder Schritt eines Zyklus einzeln abgespielt" },
    advice: { what: "Schnittdaten und Hinweise", how: "Richtwerte für Werkstoff, Werkzeug und Schneide" },
    which: { what: "Zyklus suchen", how: "Form angeben: Jeder Weg wird simuliert und verglichen" },
    code: { what: "Werkzeuge aus ISO-Bezeichnungen", how: "eine Zeile wie CNMG 120408 füllt das Werkzeug aus" },
    contour: { what: "Konturen mit Unbekannten", how: "fehlende Maße werden aus den anderen berechnet" },
    approach: { what: "APPR und DEP", how: "alle acht Funktionen, an der eigenen Kontur" },
    compare: { what: "Programme vergleichen", how: "nach ihrer Wirkung, mit der Zeit, die eine Änderung kostet" },
    drawing: { what: "Werkstattzeichnung", how: "von jedem Programm, mit Maßen, zum Drucken" },
    share: { what: "Per QR-Code teilen", how: "Programm, Werkzeuge und Prüfergebnis in einem Link" },
    verify: { what: "Prüfen auf der Kommandozeile", how: "node verify.mjs PROGRAMM.H, ohne Browser" },
  },
} satisfies StartTexts;
