import { useEffect, useEffectEvent } from "react";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import type { ImportSource } from "./tool-files.ts";

const isField = (target: EventTarget | null) =>
  target instanceof Element && target.closest("input, textarea, select, dialog, [contenteditable]") !== null;

/** Takes tools from the clipboard: by its button, or by the paste key anywhere on the page but in a field. */
export function PasteButton({
  take,
  fail,
}: {
  readonly take: (source: ImportSource) => void;
  readonly fail: (sentence: string) => void;
}) {
  const w = useTexts("tool-sheets");
  const receive = (text: string) => {
    const bytes = new TextEncoder().encode(text);
    take({ name: w.pasted, size: bytes.length, arrayBuffer: () => Promise.resolve(bytes.buffer) });
  };
  const onPaste = useEffectEvent((event: ClipboardEvent) => {
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (isField(event.target) || text.trim() === "") return;
    event.preventDefault();
    receive(text);
  });
  useEffect(() => {
    const listen = (event: ClipboardEvent) => onPaste(event);
    document.addEventListener("paste", listen);
    return () => document.removeEventListener("paste", listen);
  }, []);
  const read = () => {
    // Not every browser has it, and each may refuse.
    const clipboard = navigator.clipboard as Partial<Clipboard> | undefined;
    const text = clipboard?.readText?.() ?? Promise.reject(new Error("no clipboard"));
    text.then(receive, () => fail(w.noPaste));
  };
  return (
    <button type="button" className="button" aria-label={w.pasteLong} onClick={read}>
      <Icon name="copy" /> {w.paste}
    </button>
  );
}
