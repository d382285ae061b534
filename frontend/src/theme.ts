import { createTheme, type MantineColorsTuple } from "@mantine/core";

const cobalt: MantineColorsTuple = [
  "#e9f0fd",
  "#cfdefa",
  "#a6c3f6",
  "#79a5f1",
  "#5189ea",
  "#3474e2",
  "#1d5bd0",
  "#174aab",
  "#133d8d",
  "#0f3070",
];

export const theme = createTheme({
  primaryColor: "cobalt",
  primaryShade: { light: 6, dark: 5 },
  colors: { cobalt },
  fontFamily: "var(--font)",
  headings: { fontFamily: "var(--font)", fontWeight: "600" },
  defaultRadius: "md",
  cursorType: "pointer",
  respectReducedMotion: true,
  components: {
    // below the bar, which is above every question
    Modal: { defaultProps: { yOffset: "calc(var(--top-h) + 0.5rem)" } },
  },
});
