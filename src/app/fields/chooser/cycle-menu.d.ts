/* eslint-disable @typescript-eslint/consistent-type-imports -- A declared module cannot import from a file beside it. */
/**
 * Made by the build out of the catalogue and its texts (scripts/menu.ts), so that the first screen waits for neither.
 */
declare module "virtual:cycle-menu" {
  type MenuCycle = import("./menu.ts").MenuCycle;
  type MenuWords = import("../../../i18n/menu-words.ts").MenuWords;
  type Language = import("../../../i18n/languages.ts").Language;
  /** Every cycle of the catalogue that cuts, in menu order. */
  export const menu: readonly MenuCycle[];
  /** Those that act where they stand in a program and are no work by themselves. */
  export const acting: readonly MenuCycle[];
  /** Numbers of those that a program keeps and that are not run. */
  export const kept: readonly number[];
  /** Names of cycles and groups in a language. */
  export function menuWordsOf(language: Language): Promise<MenuWords>;
}
