import type { Cycle } from "../../../cycles/define.ts";
import { isRecalled, type Param } from "../../../cycles/params.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Parameters of a cycle that are not verified against a manual: as a whole, or only their range. */
function doubtsOf({ params }: Cycle): { readonly parameter: readonly string[]; readonly range: readonly string[] } {
  const all = Object.entries<Param>(params);
  const names = (is: (param: Param) => boolean) => all.flatMap(([q, param]) => (is(param) ? [q] : []));
  return {
    parameter: names(({ evidence }) => evidence !== "A"),
    range: names((p) => p.evidence === "A" && p.rangeEvidence !== "A" && !p.choices),
  };
}

/** What is not verified about a cycle, said once, with the parameters on demand. */
export function Unverified({ cycle }: { readonly cycle: Cycle }) {
  const { recalled, evidence } = useTexts().dialog;
  if (isRecalled(cycle))
    return (
      <p className="small soft recalled-list" title={recalled}>
        <Icon name="info" /> {recalled}
      </p>
    );
  const doubts = doubtsOf(cycle);
  const lines = (["parameter", "range"] as const).filter((kind) => doubts[kind].length > 0);
  if (lines.length === 0) return null;
  return (
    <details className="small soft recalled-list">
      <summary>
        <Icon name="info" /> {evidence.partly}
      </summary>
      {lines.map((kind) => (
        <p key={kind}>
          <span className="number">{doubts[kind].join(", ")}</span>: {evidence[kind]}
        </p>
      ))}
    </details>
  );
}
