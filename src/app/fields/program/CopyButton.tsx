import { useVerdict } from "../../findings/use-findings.ts";
import { copyJob } from "../leaving/copy-program.ts";
import { useActions } from "../../base/actions.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useEditor } from "../../document/store.ts";
import { useCopying } from "../../findings/copy.ts";
import { useFileKind } from "../../document/output.ts";

interface Props {
  readonly main?: boolean;
  readonly long?: boolean;
  /** By default the file of the open job is copied. */
  readonly copy?: () => void;
}

/** Copies the program and confirms it on the button. It is the main button only without faults. */
export function CopyButton({ main = false, long = false, copy }: Props) {
  const t = useTexts().page.text;
  const job = useEditor((s) => s.job);
  const { faults, open } = useVerdict();
  const done = useCopying((c) => c.state === "copied" && c.verdict !== null);
  const wrong = faults > 0 || open > 0;
  const kind = useFileKind();
  const run = copy ?? (job && (() => void copyJob(job)));
  useActions(run ? [{ id: "do.copy", name: t.copyLong, run }] : []);
  if (!run) return null;
  return (
    <button
      type="button"
      className={`button${main && !wrong ? " primary" : ""}`}
      aria-label={`${t.copyLong}: ${t.files[kind]}`}
      onClick={run}
    >
      <Icon name={wrong ? "warning" : done ? "check" : "copy"} />
      {done ? t.copied : long ? t.copyLong : t.copy}
    </button>
  );
}
