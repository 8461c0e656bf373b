import type { SomeParamTexts } from "../../../param-text.ts";

export const turning = {
  reverseAlong: {
    prompt: "Kontur umkehren (0-2)?",
    printed: false,
    label: "Kontur umkehren",
    explanation: "Richtung, in der die Kontur bearbeitet wird.",
    choices: {
      0: "wie programmiert",
      1: "gegen die programmierte Richtung",
      2:
        "gegen die programmierte Richtung, Schneide in Vorschubrichtung gespiegelt (Werkzeugorientierung 1 " +
        "schneidet als 3)",
    },
  },
  flankAngleRadial: {
    prompt: "Winkel Flanke?",
    printed: false,
    label: "Flankenwinkel",
    explanation:
      "Winkel zwischen der Flanke am Konturstart und der Senkrechten zur Drehachse. Der Einstich wird zum Grund " +
      "hin schmaler.",
  },
  secondFlankAngleRadial: {
    prompt: "Winkel zweite Flanke?",
    printed: false,
    label: "Winkel zweite Flanke",
    explanation: "Winkel zwischen der Flanke am Konturende und der Senkrechten zur Drehachse.",
  },
  infeedFace: {
    prompt: "Maximale Schnitttiefe?",
    printed: false,
    label: "Max. Zustellung",
    explanation:
      "Größte Zustellung je Schnitt, in Z. Die Tiefe wird gleichmäßig aufgeteilt; die tatsächliche Zustellung " +
      "ist oft kleiner, Schleifschnitte entfallen.",
  },
  infeedContour: {
    prompt: "Maximale Schnitttiefe?",
    printed: false,
    label: "Max. Zustellung",
    explanation:
      "Größte Zustellung je Schnitt, auf den Radius. Die Tiefe wird gleichmäßig aufgeteilt; die tatsächliche " +
      "Zustellung ist oft kleiner, Schleifschnitte entfallen. 0: ein Schnitt.",
  },
  plungeAngle: {
    prompt: "Winkel Flanke?",
    printed: false,
    label: "Flankenwinkel",
    explanation:
      "Winkel zwischen der Flanke am Konturstart und der Senkrechten zur Drehachse. Die Flanke fällt vom " +
      "Konturstart in den " +
      "Zerspanbereich hinein, nie hinter die Kante.",
  },
  plungeAngleFace: {
    prompt: "Winkel Flanke?",
    printed: false,
    label: "Flankenwinkel",
    explanation:
      "Winkel zwischen der Flanke am Konturstart und der Parallelen zur Drehachse. Die Flanke fällt vom " +
      "Konturstart in den " +
      "Zerspanbereich hinein, nie hinter die Kante.",
  },
} satisfies SomeParamTexts;
