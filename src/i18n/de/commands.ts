import type { CommandsTexts } from "../en/commands.ts";

export const commands: CommandsTexts = {
  title: "Befehle",
  search: "Befehle, Zyklen, Seiten suchen",
  none: "Nichts gefunden.",
  count: (n: number) => (n === 1 ? "1 Befehl" : `${n} Befehle`),
  start: "Startseite",
  course: "Kurs",
  guide: "Hilfe",
  glossary: "Glossar",
  groups: {
    recent: "Zuletzt verwendet",
    action: "Aktionen",
    page: "Seiten",
    program: "Programme",
    cycle: "Zyklen",
    lesson: "Lektionen",
    example: "Beispiele",
    setting: "Einstellungen",
  },
  kinds: {
    action: "Aktion",
    page: "Seite",
    program: "Programm",
    cycle: "Zyklus",
    lesson: "Lektion",
    example: "Beispiel",
    setting: "Einstellung",
  },
};
