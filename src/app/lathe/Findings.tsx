import { useTexts } from "../settings/use-texts.ts";
import type { LookAt } from "./places.ts";

/** What the stock simulation found, and what stays with its reason; choosing one goes to its place. */
export function Findings({ places, chosen, choose }: {
  readonly places: readonly LookAt[];
  readonly chosen: LookAt | null;
  readonly choose: (place: LookAt) => void;
}) {
  const t = useTexts().lathe;
  const found = places.filter(each => each.kind === "finding"), stays = places.filter(each => each.kind === "residual");
  const list = (name: string, all: readonly LookAt[]) => all.length > 0 && (
    <section aria-label={name}><ul>
      {all.map(each => (
        <li key={each.id}>
          <button type="button" className="lathe-finding" aria-current={chosen?.id === each.id} onClick={() => choose(each)}>
            <span className={`badge badge-${each.kind}`}>{each.mark}</span>
            <span>{each.line}</span>
          </button>
        </li>
      ))}
    </ul></section>
  );
  return (
    <details className="lathe-findings" name="lathe-more">
      <summary>
        {found.length === 0
          ? <span className="lathe-clean">{t.clear}</span>
          : <span className="lathe-faulty">{t.findingsCount(String(found.length))}</span>}
        {stays.length > 0 && <span className="lathe-stays">{t.residualCount(String(stays.length))}</span>}
      </summary>
      {found.length === 0 && <p className="soft">{t.noFindings}.</p>}
      {list(t.findings, found)}
      {list(t.residualTitle, stays)}
    </details>
  );
}
