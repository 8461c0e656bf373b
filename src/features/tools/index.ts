/* The tool table. */

export const fetchToolPage = () => import("./ToolPage.tsx");
