import type { OutputTexts } from "../en/output.ts";

export const output = {
  title: "NC-Ausgabe",
  lead: "So wird das Programm für Ihre Maschine geschrieben. Die Einstellungen werden mit dem Programm gespeichert und geteilt.",
  leadProgram: "Gilt für Bearbeitungen, die Sie einfügen. Der vorhandene Text bleibt unverändert.",
  preset: "Vorlage",
  presets: {
    manual: "Wie in den Handbuchbeispielen: M303, M305",
    mainSpindle: "Hauptspindel treibt das Werkstück an: M3, M5",
    transfer: "Ältere Dateiübertragung: M3, M5, CR LF, ohne Satznummern, Großbuchstaben",
    own: "Maschinenspezifisch",
  },
  spindleOn: "Spindel ein",
  spindleOff: "Spindel aus am Ende",
  spindleOffHint: "Leer: M30 oder M2 hält die Spindel an.",
  functionWrong: "Eine Zahl von 0 bis 999",
  retract: "Freifahren am Ende",
  retracts: {
    position: "Sichere Position über dem Rohteil",
    limit: "Verfahrgrenze in der Werkzeugachse (M140 MB MAX)",
  },
  end: "Programmende",
  ends: { 30: "M30", 2: "M2" },
  numbered: "Satznummern",
  newLine: "Zeilenende",
  newLines: { "\n": "LF", "\r\n": "CR LF" },
  name: "Programmname",
  names: { typed: "Wie eingegeben", capitals: "Großbuchstaben" },
  makeDefault: "Für neue Programme verwenden",
  isDefault: "Gilt für neue Programme.",
  unverified: "Welche M-Funktionen die Spindel antreiben, hängt von der Maschine ab: siehe Maschinenhandbuch.",
} satisfies OutputTexts;
