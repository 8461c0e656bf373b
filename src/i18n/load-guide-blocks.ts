import type { GuideBlocksTexts } from "./en/guide-blocks.ts";
import type { Language } from "./languages.ts";

/** The texts of the pages for the blocks of a program, fetched when one is shown. */
export async function loadGuideBlocks(language: Language): Promise<GuideBlocksTexts> {
  switch (language) {
    case "en":
      return (await import("./en/guide-blocks.ts")).guideBlocks;
    case "de":
      return (await import("./de/guide-blocks.ts")).guideBlocks;
    case "fr":
      return (await import("./fr/guide-blocks.ts")).guideBlocks;
    case "zh":
      return (await import("./zh/guide-blocks.ts")).guideBlocks;
  }
}
