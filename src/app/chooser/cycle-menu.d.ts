/* eslint-disable @typescript-eslint/consistent-type-imports -- A declared module cannot import from a file beside it. */
/** Made by the build out of the catalogue and its texts (scripts/menu.ts), so that the first screen waits for neither. */
declare module "virtual:cycle-menu" {
  type MenuCycle = import("./menu.ts").MenuCycle;
  type MenuWords = import("../../i18n/menu-words.ts").MenuWords;
  type Language = import("../../i18n/languages.ts").Language;
  /** Every cycle of the catalogue, in menu order. */
  export const menu: readonly MenuCycle[];
  /** Names of cycles and groups in a language. */
  export function menuWordsOf(language: Language): Promise<MenuWords>;
}
