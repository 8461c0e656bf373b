import { useTexts } from "../../app/base/settings/use-texts.ts";
import { showTools, showWhich } from "../../app/place/place.ts";

type Feature = keyof ReturnType<typeof useTexts<"first">>["start"]["beyondAll"];

const fetchShown = () => import("./shown-features.ts");

/** Where each feature can be seen at once: an address, a file of the site, or an example that opens with it. */
const PLACES: Readonly<Record<Feature, string | (() => void)>> = {
  values: () => void fetchShown().then(({ showValues }) => showValues()),
  steps: () => void fetchShown().then(({ showSteps }) => showSteps()),
  advice: "#/guide/advice",
  which: () => showWhich(),
  code: () => showTools(),
  contour: () => void fetchShown().then(({ showUnknowns }) => showUnknowns()),
  approach: () => void fetchShown().then(({ showApproach }) => showApproach()),
  compare: () => void fetchShown().then(({ showCompared }) => showCompared()),
  drawing: () => void fetchShown().then(({ showExampleDrawing }) => showExampleDrawing()),
  share: () => void fetchShown().then(({ showExampleShared }) => showExampleShared()),
  verify: "verify.mjs",
};

/** What the app does and a control does not, each one press away. */
export function Beyond() {
  const { start: t } = useTexts("first");
  return (
    <section className="start-section" aria-label={t.beyond}>
      <h2>{t.beyond}</h2>
      <ul className="beyond">
        {Object.entries(t.beyondAll).map(([id, { what, how }]) => {
          const place = PLACES[id as Feature];
          const words = (
            <>
              <b>{what}</b> <span className="small soft">{how}</span>
            </>
          );
          return (
            <li key={id}>
              {typeof place === "string" ? (
                <a className="beyond-one" href={place} {...(!place.startsWith("#") && { download: "" })}>
                  {words}
                </a>
              ) : (
                <button type="button" className="beyond-one" onClick={place}>
                  {words}
                </button>
              )}
            </li>
          );
        })}
      </ul>
    </section>
  );
}
