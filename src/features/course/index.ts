/* Lessons, tasks, and the instructor's tools. */

export const fetchCourseEntrance = () => import("./CourseEntrance.tsx");
export const fetchCoursePage = () => import("./CoursePage.tsx");
export const fetchProgramDrawing = () => import("./drawing/ProgramDrawing.tsx");
export const fetchTeachDialog = () => import("./teach/TeachDialog.tsx");
export const fetchOpenTaught = () => import("./teach/open-taught.ts");
