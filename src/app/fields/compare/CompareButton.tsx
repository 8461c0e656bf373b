import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { type ShowBlock, showComparison } from "../../place/place.ts";

/** Compares the open program with another one; a difference leads to its block. */
export function CompareButton({ showBlock }: { readonly showBlock: ShowBlock }) {
  const { page: { text: t } } = useTexts();
  return (
    <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => showComparison(showBlock)}>
      <Icon name="compare" /> {t.compare}
    </button>
  );
}
