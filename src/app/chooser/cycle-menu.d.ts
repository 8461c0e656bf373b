/** Made by the build out of the catalogue and its texts (scripts/menu.ts), so that the first screen waits for neither. */
declare module "virtual:cycle-menu" {
  /** Every cycle of the catalogue, in menu order. */
  export const menu: readonly import("./menu.ts").MenuCycle[];
  /** Names of cycles and groups in a language. */
  export function menuWordsOf(language: import("../../i18n/languages.ts").Language): Promise<import("../../i18n/menu-words.ts").MenuWords>;
}
