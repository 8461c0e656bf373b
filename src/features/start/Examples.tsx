import type { ExampleId } from "../../examples/index.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { PartPicture } from "../../app/fields/kept/PartPicture.tsx";
import { openExample } from "./open-example.ts";
import type { StartPictures } from "./pictures.ts";

/** The programs that ship with the app. */
export function Examples({ pictures }: { readonly pictures: StartPictures | null }) {
  const { programs: t, examples } = useTexts("first").page;
  return (
    <section className="start-section" aria-label={t.examples}>
      <h2>{t.examples}</h2>
      <ul className="program-examples">
        {Object.entries(examples as Readonly<Record<ExampleId, string>>).map(([id, title]) => (
          <li key={id}>
            <button
              type="button"
              className="button program-example"
              aria-label={t.example(title)}
              onClick={() => void openExample(id)}
            >
              <PartPicture of={pictures?.examples[id as ExampleId]} />
              <span>{title}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
