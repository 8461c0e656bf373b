import { useLayoutEffect, useState } from "react";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { openDropped } from "../../app/fields/open/open-program.ts";

const carriesFile = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;

/** Opens a program file dropped anywhere on the page; while it hovers, the page says so. */
export function DropProgram() {
  const t = useTexts("first").page.programs;
  const [over, setOver] = useState(false);
  // Active as soon as the page is visible.
  useLayoutEffect(() => {
    const hover = (event: DragEvent) => {
      if (!carriesFile(event)) return;
      event.preventDefault();
      setOver(true);
    };
    const leave = (event: DragEvent) => {
      if (!event.relatedTarget) setOver(false);
    };
    const drop = (event: DragEvent) => {
      setOver(false);
      if (!carriesFile(event) || !event.dataTransfer) return;
      event.preventDefault();
      event.stopPropagation();
      void openDropped(event.dataTransfer);
    };
    addEventListener("dragover", hover);
    addEventListener("dragleave", leave);
    addEventListener("drop", drop, true);
    return () => {
      removeEventListener("dragover", hover);
      removeEventListener("dragleave", leave);
      removeEventListener("drop", drop, true);
    };
  }, []);
  return over ? <p className="drop-here">{t.dropHere}</p> : null;
}
