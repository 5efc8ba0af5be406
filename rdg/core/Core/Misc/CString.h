// C string functions under the engine's names. Source: engine Misc/CString.h.
#pragma once

#include "CoreTypes.h"

#include <cstdlib>
#include <cstring>
#include <strings.h>

struct FCString
{
	static int32 Strlen(const TCHAR* Text) { return static_cast<int32>(std::strlen(Text)); }
	static int32 Strcmp(const TCHAR* A, const TCHAR* B) { return std::strcmp(A, B); }
	static int32 Strncmp(const TCHAR* A, const TCHAR* B, SIZE_T Count) { return std::strncmp(A, B, Count); }
	/** Ignoring the case of ASCII letters. */
	static int32 Stricmp(const TCHAR* A, const TCHAR* B) { return ::strcasecmp(A, B); }
	static int32 Strnicmp(const TCHAR* A, const TCHAR* B, SIZE_T Count) { return ::strncasecmp(A, B, Count); }
	static const TCHAR* Strstr(const TCHAR* Text, const TCHAR* Part) { return std::strstr(Text, Part); }
	static const TCHAR* Strchr(const TCHAR* Text, TCHAR Character) { return std::strchr(Text, Character); }
	static const TCHAR* Strrchr(const TCHAR* Text, TCHAR Character) { return std::strrchr(Text, Character); }
	static int32 Atoi(const TCHAR* Text) { return std::atoi(Text); }
	static int64 Atoi64(const TCHAR* Text) { return std::atoll(Text); }
	static float Atof(const TCHAR* Text) { return std::strtof(Text, nullptr); }
	static double Atod(const TCHAR* Text) { return std::strtod(Text, nullptr); }
};

using FCStringAnsi = FCString;
