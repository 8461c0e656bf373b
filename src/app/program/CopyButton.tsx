import { Icon } from "../Icon.tsx";
import { printedText } from "../printed.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useEditor } from "../store.ts";
import { copyText, useCopying } from "./copy.ts";

/** Copies the program, and says so on its own face. */
export function CopyButton({ className = "", long = false }: { readonly className?: string; readonly long?: boolean }) {
  const t = useTexts().page.text;
  const job = useEditor((s) => s.job);
  const done = useCopying((c) => c.state === "copied");
  if (!job) return null;
  return (
    <button type="button" className={`button ${className}`} aria-label={t.copyLong} onClick={() => void copyText(printedText(job))}>
      <Icon name={done ? "check" : "copy"} />
      {done ? t.copied : long ? t.copyLong : t.copy}
    </button>
  );
}
