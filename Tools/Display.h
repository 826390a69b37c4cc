// An X display for a VTK that cannot render without one (GLX only: Debian's 9.2).
#ifndef vtkshadows_Display_h
#define vtkshadows_Display_h

namespace vtkshadows
{

// Before a window is made. Where VTK would abort for want of an X display, start an Xvfb that ends
// with this process, and set DISPLAY; true if one was started. From VTK 9.4 on nothing is done: VTK
// falls back to EGL or OSMesa. Throws Failure where Xvfb is needed and missing.
bool ProvideDisplay();

}

#endif
