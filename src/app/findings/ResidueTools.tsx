import { useState } from "react";
import { writer } from "../../i18n/write.ts";
import type { Remedy } from "../../report/remedies.ts";
import { remediesOf } from "../calculation/tool-questions.ts";
import { useOutcome } from "../calculation/outcome.ts";
import { useLengths } from "../calculation/lengths.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import { regionOfResidual } from "../document/residual-region.ts";
import { WhichButton } from "../document/WhichButton.tsx";
import type { FindingEntry } from "./entry.ts";
import type { FindingsHost } from "./host.ts";
import { useFixesHeldBack } from "./task-result.ts";
import { NO_AREA } from "./effect/effect.ts";

/** Most tools that are offered; the others leave more. */
const MOST = 4;

/** Causes of residual material that another tool may avoid. */
const byTool: ReadonlySet<string> = new Set(["insertRadius", "mainEdge", "secondaryEdge", "toolWidth", "cutLength"]);

/** Whether another tool may remove the residual material of a finding. */
export const isLeftByTool = ({ issue }: FindingEntry): boolean =>
  issue.code === "materialLeft" && byTool.has(issue.data.reason);

/**
 * Tools of the table that would remove residual material, tried on request, least left first. `isOpen`: with the other
 * way, another cycle.
 */
export function ResidueTools({
  entry,
  host,
  isOpen,
}: {
  readonly entry: FindingEntry;
  readonly host: FindingsHost;
  readonly isOpen: boolean;
}) {
  const t = useTexts();
  const words = t.findings.residue;
  const write = writer(useLengths());
  const newest = useOutcome((s) => s.newest);
  const isHeldBack = useFixesHeldBack();
  const [asked, ask] = useState<{ readonly of: typeof newest; readonly tools: readonly Remedy[] | "trying" | null }>({
    of: null,
    tools: null,
  });
  const left = entry.residual === null ? undefined : newest?.simulation.proof.residual[entry.residual];
  const operation = left && newest?.run.operations[left.operation];
  if (!left || !operation || isHeldBack) return null;
  const which = (
    <WhichButton
      name={words.askCycle}
      className="button small mend"
      regionOf={() => regionOfResidual(left, operation, newest.simulation.final)}
    />
  );
  if (!byTool.has(left.reason)) return which;
  const tools = asked.of === newest ? asked.tools : null;
  const tryAll = async () => {
    ask({ of: newest, tools: "trying" });
    const found = await remediesOf(operation, left);
    ask({ of: newest, tools: found ?? [] });
  };
  return (
    <>
      {isOpen && which}
      {tools === null && (
        <button type="button" className="button small mend" onClick={() => void tryAll()}>
          {words.ask}
        </button>
      )}
      <div role="status" className={tools === null ? "unseen" : "finding-tools"}>
        {tools === "trying" && <p className="small soft">{words.trying}</p>}
        {Array.isArray(tools) && tools.length === 0 && <p className="small">{words.none}</p>}
        {Array.isArray(tools) && tools.length > 0 && (
          <ul>
            {(tools as readonly Remedy[]).slice(0, MOST).map(({ tool, residualArea }) => {
              const name = `${tool.T} ${tool.NAME}`;
              return (
                <li key={tool.T}>
                  <span className="small">
                    {residualArea < NO_AREA ? words.all(name) : words.leaves(name, write.area(residualArea))}
                  </span>
                  <button type="button" className="button small mend" onClick={() => host.takeTool(entry, tool.T)}>
                    {t.setup.tool.take(tool.T)}
                  </button>
                </li>
              );
            })}
          </ul>
        )}
      </div>
    </>
  );
}
