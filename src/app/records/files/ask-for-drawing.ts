import { DRAWING_ENDINGS } from "../../../program/drawing/endings.ts";

/** Asks for a drawing; null when the operator closes the question. */
export function askForDrawing(): Promise<File | null> {
  return new Promise((resolve) => {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = DRAWING_ENDINGS.join(",");
    input.addEventListener("change", () => resolve(input.files?.[0] ?? null));
    input.addEventListener("cancel", () => resolve(null));
    input.click();
  });
}
