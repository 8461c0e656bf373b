import { useVerdict } from "../../findings/use-findings.ts";
import { copyJob } from "../leaving/copy-program.ts";
import { useActions } from "../../base/actions.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useEditor } from "../../document/store.ts";
import { useCopying } from "../../findings/copy.ts";
import { useFileKind } from "../../document/output.ts";

/** Copies the program and confirms it on the button. It is the main button only without faults. */
export function CopyButton({ main = false, long = false }: { readonly main?: boolean; readonly long?: boolean }) {
  const t = useTexts().page.text;
  const job = useEditor((s) => s.job);
  const { faults, open } = useVerdict();
  const done = useCopying((c) => c.state === "copied" && c.verdict !== null);
  const wrong = faults > 0 || open > 0;
  const kind = useFileKind();
  useActions(job ? [{ id: "do.copy", name: t.copyLong, run: () => void copyJob(job) }] : []);
  if (!job) return null;
  return (
    <button
      type="button"
      className={`button${main && !wrong ? " primary" : ""}`}
      aria-label={`${t.copyLong}: ${t.files[kind]}`}
      onClick={() => void copyJob(job)}
    >
      <Icon name={wrong ? "warning" : done ? "check" : "copy"} />
      {done ? t.copied : long ? t.copyLong : t.copy}
    </button>
  );
}
