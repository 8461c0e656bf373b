import { expect, test } from "vitest";
import { partProblem } from "../planning/part/part-problem.ts";
import type { Language } from "./languages.ts";
import { message } from "./message.ts";
import { partProblemText } from "./part-problem.ts";
import { loadTexts } from "./parts.ts";

const crossing = partProblem("crosses", { x: 20.5, z: -10 }, { side: "outside", row: "e4" });

test.each([
  ["en", "Outside contour e4: The contour crosses itself at X20.5 Z−10."],
  ["de", "Außenkontur e4: Die Kontur schneidet sich selbst bei X20,5 Z−10."],
  ["fr", "Contour extérieur e4 : Le contour se recoupe en X20,5 Z−10."],
  ["zh", "外轮廓 e4：轮廓在 X20.5 Z−10 自相交。"],
] as const)("a problem in %s names contour, row and place", async (language: Language, wanted) => {
  const words = await loadTexts(language, "part");
  const said = partProblemText(language, crossing, words, (issue) => message(language, issue));
  expect(said.replaceAll("-10", "−10")).toBe(wanted);
});
