import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** In the link to the course on the start page: its name, and where it leads. */
export function EntranceWords({ about }: { readonly about: string }) {
  const { entrance: t } = useTexts("course");
  return (
    <>
      <b>{t.name}</b> <span className="soft">{about}</span>
      <Icon name="fold" />
    </>
  );
}
