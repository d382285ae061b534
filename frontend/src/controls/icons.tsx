import type { ReactNode } from "react";

interface IconProps {
  size?: number | string;
}

function Drawing({ size = "1.5rem", children }: IconProps & { children: ReactNode }) {
  return (
    <svg
      width={size}
      height={size}
      viewBox="0 0 24 24"
      fill="none"
      stroke="currentColor"
      strokeWidth={1.75}
      strokeLinecap="round"
      strokeLinejoin="round"
      aria-hidden="true"
      focusable="false"
      style={{ flex: "none" }}
    >
      {children}
    </svg>
  );
}

const icon = (drawing: ReactNode) => (props: IconProps) => <Drawing {...props}>{drawing}</Drawing>;

export const HomeIcon = icon(<path d="M4 11 12 4l8 7v8.5a.5.5 0 0 1-.5.5H14v-6h-4v6H4.5a.5.5 0 0 1-.5-.5z" />);
export const CalibrateIcon = icon(<path d="M3 19V8h4v6h3V8h4v6h3V8h4v11zM2 11.5h20" />);
export const ScanIcon = icon(
  <path d="M4 8V5a1 1 0 0 1 1-1h3M16 4h3a1 1 0 0 1 1 1v3M20 16v3a1 1 0 0 1-1 1h-3M8 20H5a1 1 0 0 1-1-1v-3M3 12h4l2.5-3 3 6 2.5-3h6" />,
);
export const DatasheetsIcon = icon(<path d="M6 20V4h8.500L18 7.500V20zM14 4v4h4M9 12h6M9 16h6" />);
export const ArmIcon = icon(
  <>
    <path d="M4 20h7M7.5 20v-5" />
    <circle cx="7.5" cy="13" r="2" />
    <path d="m8.600 11.400 4.900-5.900" />
    <circle cx="14.700" cy="4.500" r="1.500" />
    <path d="M15.700 5.600 19 11.500v4.500" />
    <path d="M16.500 20 19 16l2.500 4" />
  </>,
);
export const VerifyIcon = icon(
  <>
    <circle cx="12" cy="12" r="8.500" />
    <path d="m8 12.300 2.800 2.800L16 9.500" />
  </>,
);
export const PartIcon = icon(
  <>
    <path d="M3 8.500 12 4l9 4.500v8L12 21l-9-4.500zM3 8.500 12 13l9-4.500M12 13v8" />
    <circle cx="7.500" cy="14" r="1.500" />
  </>,
);
export const PerformanceIcon = icon(
  <>
    <circle cx="12" cy="10" r="6.500" />
    <path d="M12 16.500V20M8 20.500h8M9 9.500l3-2 3 2M12 7.500v5" />
  </>,
);
export const RecordsIcon = icon(<path d="M5 4h10l4 4v12H5zM15 4v4h4M8.5 12h7M8.5 15.5h7" />);
export const SuperviseIcon = icon(<path d="M3 5h18v11H3zM9 20h6M12 16v4M6.500 12.500l3-3.500 2.500 2.500 4-4.500" />);
export const HealthIcon = icon(
  <path d="M12 20C5 15 3 11.500 3 8.500A4.500 4.500 0 0 1 12 7a4.500 4.500 0 0 1 9 1.500c0 3-2 6.500-9 11.500zM6 12h3l1.500-3 3 5 1.500-2h3" />,
);
export const SettingsIcon = icon(
  <>
    <path d="M3 7h9M17 7h4M3 17h4M12 17h9" />
    <circle cx="14.5" cy="7" r="2.5" />
    <circle cx="9.5" cy="17" r="2.5" />
  </>,
);
export const PeopleIcon = icon(
  <>
    <circle cx="9" cy="8" r="3.5" />
    <path d="M2.500 20c0-3.600 2.900-6 6.500-6s6.500 2.400 6.500 6M15.500 4.800a3.500 3.500 0 0 1 0 6.400M18 14.600c2.200.8 3.500 2.800 3.500 5.400" />
  </>,
);
export const HelpIcon = icon(
  <>
    <circle cx="12" cy="12" r="9" />
    <path d="M9.500 9.500a2.500 2.500 0 1 1 3.500 2.300c-.700.300-1 .800-1 1.700M12 16.600v.1" />
  </>,
);
export const MenuIcon = icon(<path d="M4 7h16M4 12h16M4 17h16" />);
export const CheckIcon = icon(<path d="m5 12.5 4.5 4.5L19 7.5" />);
export const AttentionIcon = icon(<path d="M12 4 2.5 20h19zM12 10v4.5M12 17.4v.1" />);
export const BadIcon = icon(
  <path d="M8.200 3h7.600L21 8.200v7.600L15.800 21H8.200L3 15.800V8.200zM9 9l6 6M15 9l-6 6" />,
);
export const NeutralIcon = icon(
  <>
    <circle cx="12" cy="12" r="9" />
    <path d="M12 11v5M12 7.9v.1" />
  </>,
);
export const StopIcon = icon(
  <>
    <path d="M8.200 3h7.600L21 8.200v7.600L15.800 21H8.200L3 15.800V8.200z" />
    <rect x="9" y="9" width="6" height="6" fill="currentColor" stroke="none" />
  </>,
);
export const LaserIcon = icon(
  <path d="M3 12h8M15 12h.01M15 5v2.5M15 16.5V19M20 12h1M18.5 8.5l1.300-1.300M18.5 15.5l1.300 1.300" />,
);
export const SunIcon = icon(
  <>
    <circle cx="12" cy="12" r="4" />
    <path d="M12 3v1.5M12 19.5V21M3 12h1.5M19.5 12H21M5.600 5.600l1.100 1.100M17.300 17.300l1.100 1.100M5.600 18.4l1.100-1.100M17.300 6.700l1.100-1.100" />
  </>,
);
export const MoonIcon = icon(<path d="M20 14.5A8.5 8.5 0 0 1 9.5 4a8.5 8.5 0 1 0 10.5 10.5z" />);
export const SoundIcon = icon(<path d="M4 9.5v5h3.5L12 18V6L7.5 9.5zM15.5 9a4 4 0 0 1 0 6M18 6.5a8 8 0 0 1 0 11" />);
export const MutedIcon = icon(<path d="M4 9.5v5h3.5L12 18V6L7.5 9.5zM16 9.5l5 5M21 9.5l-5 5" />);
export const DownloadIcon = icon(<path d="M12 4v11M7 10.5l5 5 5-5M5 20h14" />);
export const CloseIcon = icon(<path d="m6 6 12 12M18 6 6 18" />);
export const CopyIcon = icon(<path d="M9 9h11v11H9zM15 9V4H4v11h5" />);
export const ArrowIcon = icon(<path d="M5 12h14M13 6l6 6-6 6" />);
export const StaleIcon = icon(<path d="M19 8A8 8 0 1 0 20 13M19.5 3.5V8.5h-5" />);
export const ColoursIcon = icon(<path d="M4 19V9h4v10zM10 19V5h4v14zM16 19v-7h4v7z" />);
export const MeasureIcon = icon(
  <>
    <path d="M4 8V4h4M16 4h4v4M20 16v4h-4M8 20H4v-4" />
    <circle cx="12" cy="12" r="4" />
  </>,
);
export const CompareIcon = icon(<path d="M4 8.500 12 4l8 4.500v7L12 20l-8-4.500zM4 8.500l8 4.500 8-4.500M12 13v7" />);
export const CutIcon = icon(
  <>
    <circle cx="6" cy="6.500" r="2.500" />
    <circle cx="6" cy="17.500" r="2.500" />
    <path d="M8 8.500 20 18M8 15.500 20 6" />
  </>,
);
export const CloudsIcon = icon(<path d="m12 4 9 5-9 5-9-5zM3.5 13.5 12 18.500l8.500-5" />);
export const CameraIcon = icon(
  <>
    <path d="M4 8h3.500L9 5.500h6L16.500 8H20v11H4z" />
    <circle cx="12" cy="13" r="3.500" />
  </>,
);
export const DevicesIcon = icon(<path d="M9 3v5M15 3v5M6 8h12v4a6 6 0 0 1-12 0zM12 18v3" />);
export const PlaneIcon = icon(<path d="M8 7h13l-5 10H3z" />);
export const SphereIcon = icon(
  <>
    <circle cx="12" cy="12" r="8.500" />
    <path d="M3.500 12c0 4 17 4 17 0" />
  </>,
);
export const CylinderIcon = icon(
  <>
    <ellipse cx="12" cy="6" rx="6.500" ry="2.500" />
    <path d="M5.500 6v12c0 3.300 13 3.300 13 0V6" />
  </>,
);

export const UndoIcon = icon(<path d="M8 5L4 9l4 4M4.500 9H14a5.500 5.500 0 0 1 0 11H9" />);

export const ConeIcon = icon(
  <>
    <ellipse cx="12" cy="18" rx="7" ry="2.500" />
    <path d="M5 18l7-15 7 15" />
  </>,
);

/** The house's mark: a crenellated block crossed by the stripe. */
export function Mark({ size = "2.25rem" }: IconProps) {
  return (
    <svg width={size} height={size} viewBox="0 0 32 32" aria-hidden="true" focusable="false" style={{ flex: "none" }}>
      <path d="M4 26V8h7v8h4V8h5v8h4V8h4v18z" fill="currentColor" />
      <path d="M1 20.5h30" stroke="#e5484d" strokeWidth="2" />
    </svg>
  );
}
