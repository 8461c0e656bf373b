/** scripts/NAME.ts with all its imports as the text of one module for plain Node. */
export function bundle(name: string, how?: { readonly minify?: boolean }): Promise<string>;
/**
 * The page objects of the e2e tests as a module that needs only Playwright, its types, and its files of languages by
 * their names.
 */
export function pageObjects(): Promise<PageObjects>;
export interface PageObjects {
  readonly code: string;
  readonly types: string;
  readonly languages: Readonly<Record<string, string>>;
}
