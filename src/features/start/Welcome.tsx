import { LivePicture } from "./LivePicture.tsx";
import type { StartPictures } from "./pictures.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** What this page shows and a control does not, next to a running program. */
export function Welcome({ pictures }: { readonly pictures: StartPictures | null }) {
  const { start: t } = useTexts("first").page;
  return (
    <section className="welcome" aria-label={t.beyond}>
      <LivePicture run={pictures?.live} />
      <div className="welcome-words">
        <h2>{t.beyond}</h2>
        <ul>
          {Object.entries(t.beyondAll).map(([id, { what, how }]) => (
            <li key={id}>
              <b>{what}</b> <span>{how}</span>
            </li>
          ))}
        </ul>
      </div>
    </section>
  );
}
