import type { PlanComparisonTexts } from "../en/plan-comparison.ts";

export const planComparison: PlanComparisonTexts = {
  title: "Zwei Pläne für ein Teil",
  about:
    "Der Planer hat für dieselbe Zeichnung mit denselben Werkzeugen einen Arbeitsplan gemacht. Keiner der beiden ist der einzig richtige: Jeder Unterschied wurde in Ihrem Programm ausprobiert und das ganze Teil neu geprüft.",
  planning: (tries) => `Der Planer arbeitet: ${tries} Bearbeitungen ausprobiert`,
  trying: (n) => `Der Weg des Planers in Ihrem Programm: Unterschied ${n} wird ausprobiert`,
  failed: "Der Vergleich konnte nicht berechnet werden.",
  noPlan: "Für diese Zeichnung lässt sich kein Arbeitsplan machen.",
  noProgram: "Ihr Programm hat noch keine Bearbeitung.",
  again: "Nochmals versuchen",
  yours: "Ihr Plan",
  planner: "Planer",
  whole: "Das ganze Teil",
  facts: { time: "Zeit", changes: "Werkzeugwechsel", tools: "Werkzeuge", left: "Restmaterial", goals: "Ziele" },
  met: "alle erreicht",
  missed: (goals) => `nicht erreicht: ${goals}`,
  withChanges: (time) => `In den Zeiten sind ${time} je Werkzeugwechsel enthalten.`,
  summary: (differences, planner, own) =>
    differences === 0
      ? "Beide Pläne tun dasselbe."
      : `Ausprobierte Unterschiede: ${differences}. In ${planner} ist der Weg des Planers besser, in ${own} Ihrer.`,
  rows: "Bearbeitung für Bearbeitung",
  onlyYours: "nur in Ihrem Plan",
  onlyPlanner: "nur im Plan des Planers",
  nothing: "keine solche Bearbeitung",
  number: (n) => `Nr. ${n}`,
  thread: "Gewinde",
  differs: {
    same: "gleiches Werkzeug, gleicher Zyklus",
    tool: "anderes Werkzeug",
    cycle: "anderer Zyklus",
    count: (own, planner) => `${own} : ${planner} Bearbeitungen`,
    earlier: "beim Planer früher",
    later: "beim Planer später",
    faster: (time) => `Ihre ${time} schneller`,
    slower: (time) => `Planer ${time} schneller`,
    sameTime: "gleiche Zeit",
  },
  why: "Warum der Planer es so macht",
  values: { title: "Andere Werte", value: "Wert", reason: "Formel des Planers" },
  tried: {
    way: "Ihr Programm mit dem Weg des Planers",
    order: "Ihr Programm in der Reihenfolge des Planers",
    none: "Ließ sich nicht in Ihr Programm schreiben.",
    time: (time, difference) => `${time} (${difference})`,
    left: (area) => `${area} Restmaterial`,
    clean: "kein Restmaterial",
    changes: (n) => `${n} Werkzeugwechsel`,
    better: {
      own: "Ihr Weg ist besser",
      other: "Der Weg des Planers ist besser",
      same: "Kein Unterschied im Ergebnis",
    },
  },
};
