/* oxlint-disable typescript/consistent-type-imports -- A declared module cannot import from a file beside it. */
/** Generated from the catalogue and its texts (scripts/menu.ts), so that the first screen need not load them. */
declare module "virtual:cycle-menu" {
  type MenuCycle = import("./menu.ts").MenuCycle;
  type MenuWords = import("../../../i18n/menu-words.ts").MenuWords;
  type Language = import("../../../i18n/languages.ts").Language;
  /** Every cycle of the catalogue that cuts, in menu order. */
  export const menu: readonly MenuCycle[];
  /** DEF-active cycles, which are used only inside a program. */
  export const acting: readonly MenuCycle[];
  /** Numbers of cycles that a program may contain but that are not simulated. */
  export const kept: readonly number[];
  /** Names of cycles and groups in a language. */
  export function menuWordsOf(language: Language): Promise<MenuWords>;
}
