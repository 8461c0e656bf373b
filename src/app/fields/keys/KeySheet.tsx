import { ModalDialog } from "../../base/ModalDialog.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { KEY_LIST, KEY_PLACES, type KeyPlace } from "../../base/key-list.ts";
import { KeyCombination } from "./KeyCombination.tsx";
import "./keys.css";

/** All keyboard shortcuts by place; those of the place it was opened from come first. */
export function KeySheet({ place, done }: { readonly place: KeyPlace; readonly done: () => void }) {
  const t = useTexts("keys");
  const places = [place, ...KEY_PLACES.filter((other) => other !== place)];
  return (
    <ModalDialog title={t.title} done={done} className="modal key-sheet">
      {places.map((each) => {
        const does: Readonly<Record<string, string>> = t.does[each];
        return (
          <section key={each} aria-labelledby={`keys-${each}`}>
            <h3 id={`keys-${each}`}>{t.places[each]}</h3>
            <dl>
              {Object.entries<readonly string[]>(KEY_LIST[each]).map(([id, keys]) => (
                <div key={id}>
                  <dt>
                    {keys.map((combination) => (
                      <KeyCombination key={combination} keys={combination} names={t.names} />
                    ))}
                  </dt>
                  <dd>{does[id]}</dd>
                </div>
              ))}
            </dl>
          </section>
        );
      })}
    </ModalDialog>
  );
}
