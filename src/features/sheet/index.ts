/* The setup sheet. */

export const fetchSheetPage = () => import("./SheetPage.tsx");
