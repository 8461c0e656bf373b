import type { Page } from "@playwright/test";

const MARK = "blocked by the content policy:";

/**
 * Calls back for everything that the content policy blocks on a page, in pages opened from now on. A browser writes
 * style attributes into text that is typed over in the program editor, which blocks them and would drop them anyway.
 */
export async function onBlocked(page: Page, note: (what: string) => void): Promise<void> {
  page.on("console", (line) => line.text().startsWith(MARK) && note(line.text()));
  await page.addInitScript((mark) => {
    document.addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI, sourceFile }) => {
      const isTyped = effectiveDirective === "style-src-attr" && document.activeElement?.closest(".cm-content");
      if (!isTyped) console.warn(mark, effectiveDirective, blockedURI, sourceFile);
    });
  }, MARK);
}

/** Whether a line of the console is the browser's own message of a violation, which `onBlocked` reports. */
export const isPolicyMessage = (text: string): boolean => text.includes("Content Security Policy");
