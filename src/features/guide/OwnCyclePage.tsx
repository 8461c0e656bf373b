import { formatNumber } from "../../i18n/number.ts";
import { OWN_DECIMALS, type OwnCycle } from "../../program/edits/own-cycle.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The page of an own cycle, the given parameter first: its description, and a note that it is not simulated. */
export function OwnCyclePage({ own, q }: { readonly own: OwnCycle; readonly q: string | null }) {
  const t = useTexts("guide");
  const { dialog } = useTexts();
  const { own: words } = useTexts("tables");
  const language = useSettings((s) => s.language);
  const number = (value: number) => formatNumber(language, value, OWN_DECIMALS);
  const sorted = own.parameters.toSorted((a, b) => Number(b.q === q) - Number(a.q === q));
  return (
    <>
      <header className="guide-head">
        <h1>
          <span className="number prompt-q">{own.number}</span> {own.name}
        </h1>
        <p>{words.unprovedLong}</p>
      </header>
      <section aria-label={t.parameters}>
        <h2>{t.parameters}</h2>
        <dl className="guide-points">
          {sorted.map((param) => (
            <div key={param.q} data-asked={param.q === q || undefined}>
              <dt>
                <b className="number">{param.q}</b> {param.prompt}
              </dt>
              <dd>
                {param.choices ? (
                  <ul>
                    {param.choices.map(({ value, meaning }) => (
                      <li key={value}>
                        <b className="number">{value}</b> {meaning}
                      </li>
                    ))}
                  </ul>
                ) : param.bounded ? (
                  `${t.range}: ${dialog.range(number(param.range[0]), number(param.range[1]))}`
                ) : (
                  words.anyNumber
                )}
              </dd>
            </div>
          ))}
        </dl>
      </section>
    </>
  );
}
