import { useMemo } from "react";
import { writeTyped } from "../dialog/write-value.ts";
import { useOutcome } from "../engine/outcome.ts";
import type { FindingEntry } from "../findings/entry.ts";
import type { FindingsHost, Mend } from "../findings/host.ts";
import { showSection } from "../place.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { fixOf } from "./diagnostics.ts";
import { indexOf, repairsOf, withTool, type Repair } from "./repairs.ts";
import { dispatchEdit, editProgram, openBlock, sessionText, sessionView, useSession } from "./session.ts";

/** Decimals of offered values. */
const DECIMALS = 4;

/** The workplace of a whole program: its blocks and their dialogs. What is found in an older text offers no changes. */
export function useProgramHost(): FindingsHost {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const reading = useSession((s) => s.reading);
  const newest = useOutcome((s) => s.newest);
  return useMemo(() => {
    const { program } = reading;
    const isPresent = () => newest !== null && newest.text === sessionText();
    const nameOf = ({ kind, text, block }: Repair): string => {
      if (kind === "take") return t.dialog.takeNearest(typeof text === "number" ? writeTyped(language, text, DECIMALS) : text);
      if (kind === "write") return t.findings.write(String(text), block);
      return kind === "insert" ? t.findings.insert(String(text)) : t.findings.remove(String(text));
    };
    const open = (entry: FindingEntry) => openBlock(indexOf(program, entry), entry.at);
    const targetOf: FindingsHost["targetOf"] = (entry) => {
      const index = indexOf(program, entry);
      if (index < 0) return null;
      const go = () => {
        open(entry);
        showSection("block");
      };
      return { name: t.findings.inBlock(String(entry.block ?? index)), go };
    };
    const remediesOf: FindingsHost["remediesOf"] = (entry) => {
      const view = sessionView();
      if (!view || !isPresent()) return [];
      const repairs = repairsOf(program, entry, language).map((repair): Mend => ({
        name: nameOf(repair),
        apply: () => {
          editProgram(repair.next(), null, repair.open);
          if (repair.asks) showSection("block");
        },
      }));
      const tool = entry.issue.code === "betterTool" && repairs.length === 0 ? entry.issue.data.tool : null;
      if (tool !== null) return [{ name: t.setup.tool.take(tool), apply: () => takeTool(entry, tool) }];
      const fix = fixOf(view.state, entry);
      return fix ? [{ name: t.findings.fix, apply: () => dispatchEdit(fix, null) }, ...repairs] : repairs;
    };
    const takeTool: FindingsHost["takeTool"] = (entry, tool) => {
      const index = indexOf(program, entry);
      if (index >= 0 && isPresent()) editProgram(withTool(program, index, tool), null);
    };
    const cycleOf: FindingsHost["cycleOf"] = (entry) => {
      const s = program.blocks[indexOf(program, entry)]?.statement;
      return s?.kind === "cycle" ? s.cycle : null;
    };
    return { targetOf, remediesOf, cycleOf, point: open, toFirstOpen: () => undefined, takeTool };
  }, [t, language, reading, newest]);
}
