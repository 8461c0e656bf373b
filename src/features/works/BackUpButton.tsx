import { Icon } from "../../app/base/Icon.tsx";
import { unsavedNames } from "../../app/records/keep.ts";
import { saveBackup } from "./export-works.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The button that downloads a backup of this device; `say` gets the result as a sentence. */
export function BackUpButton({ say }: { readonly say: (what: string) => void }) {
  const t = useTexts("device").here;
  const save = async () => {
    try {
      const { works, files } = await saveBackup(unsavedNames());
      say(t.exported(works, files));
    } catch {
      say(t.notExported);
    }
  };
  return (
    <button type="button" className="button" aria-label={t.exportLong} title={t.exportLong} onClick={() => void save()}>
      <Icon name="download" /> {t.exportAll}
    </button>
  );
}
