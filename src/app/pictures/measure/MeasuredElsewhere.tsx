import "./measure.css";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Note over a picture that cannot show measurements: how many there are, and where to see them. */
export const MeasuredElsewhere = ({ count }: { readonly count: number }) => {
  const t = useTexts("measure");
  return (
    <p role="status" className="measured-elsewhere small">
      {t.inSection(String(count))}
    </p>
  );
};
