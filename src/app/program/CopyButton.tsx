import { useVerdict } from "../findings/use-findings.ts";
import { copyProgram } from "../leaving/copy-program.ts";
import { Icon } from "../Icon.tsx";
import { printedText } from "../printed.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useEditor } from "../store.ts";
import { useCopying } from "./copy.ts";

/** Copies the program, and says so on its own face. It is the main button only while nothing is wrong. */
export function CopyButton({ main = false, long = false }: { readonly main?: boolean; readonly long?: boolean }) {
  const t = useTexts().page.text;
  const job = useEditor((s) => s.job);
  const { faults, open } = useVerdict();
  const done = useCopying((c) => c.state === "copied" && c.verdict !== null);
  const wrong = faults > 0 || open > 0;
  if (!job) return null;
  return (
    <button type="button" className={`button${main && !wrong ? " primary" : ""}`} aria-label={t.copyLong}
      onClick={() => void copyProgram(printedText(job))}
    >
      <Icon name={wrong ? "warning" : done ? "check" : "copy"} />
      {done ? t.copied : long ? t.copyLong : t.copy}
    </button>
  );
}
