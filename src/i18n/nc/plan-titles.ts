import type { NcLanguage } from "../../nc/nc-languages.ts";

/** Words of the structure items of a planned program, by the kind of operation. */
const titles = {
  en: {
    face: "FACE",
    centre: "CENTRE DRILL",
    drill: "DRILL",
    roughOutside: "ROUGH OUTSIDE",
    roughInside: "ROUGH BORE",
    restRough: "ROUGH RESIDUAL MATERIAL",
    recess: "RECESS",
    finishOutside: "FINISH OUTSIDE",
    finishInside: "FINISH BORE",
    ream: "REAM",
    undercut: "UNDERCUT",
    thread: "THREAD",
    partOff: "PART OFF",
  },
  de: {
    face: "PLANEN",
    centre: "ZENTRIEREN",
    drill: "BOHREN",
    roughOutside: "AUSSEN SCHRUPPEN",
    roughInside: "INNEN SCHRUPPEN",
    restRough: "RESTMATERIAL SCHRUPPEN",
    recess: "EINSTECHEN",
    finishOutside: "AUSSEN SCHLICHTEN",
    finishInside: "INNEN SCHLICHTEN",
    ream: "REIBEN",
    undercut: "FREISTICH",
    thread: "GEWINDE",
    partOff: "ABSTECHEN",
  },
  fr: {
    face: "DRESSAGE",
    centre: "CENTRAGE",
    drill: "PERCAGE",
    roughOutside: "EBAUCHE EXTERIEURE",
    roughInside: "EBAUCHE INTERIEURE",
    restRough: "EBAUCHE MATIERE RESIDUELLE",
    recess: "GORGE",
    finishOutside: "FINITION EXTERIEURE",
    finishInside: "FINITION INTERIEURE",
    ream: "ALESOIR",
    undercut: "DEGAGEMENT",
    thread: "FILETAGE",
    partOff: "TRONCONNAGE",
  },
} as const;

/** The titles of the operations of a plan. A control set to Chinese shows English words. */
export const planTitles = (language: NcLanguage): Readonly<Record<keyof typeof titles.en, string>> =>
  titles[language === "zh" ? "en" : language];
