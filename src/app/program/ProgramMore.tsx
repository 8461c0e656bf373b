import { handOver } from "../store.ts";
import { Icon } from "../Icon.tsx";
import { useTexts } from "../settings/use-texts.ts";
import { showSheet } from "../sheet/sheet-place.ts";

/** What else can be made of the open program, in one row below its ways out. */
export function ProgramMore() {
  const { page: { text: t } } = useTexts();
  return (
    <div className="program-more">
      <button type="button" className="button plain" onClick={() => {
        handOver();
        showSheet();
      }}>
        <Icon name="print" /> {t.setupSheet}
      </button>
    </div>
  );
}
