// The engine's property text as a tree: `(bOverride_BloomIntensity=True,BloomIntensity=1.200000,...)`. Names, indices
// and values as they are written; no field is known here. Source: engine text of pasted properties (public samples).
#pragma once

#include "PostProcessSettingsTextErrors.h"

#include <string>
#include <vector>

namespace Drydock
{

enum class EEngineTextKind
{
	Nothing, // `Array=` has no value
	Bool,    // True, False, in any case
	Number,  // NaN and infinity too: it is for a field to refuse them
	Name,    // BM_FFT, EFoo::Bar, None, NSLOCTEXT(..): what no other kind claims
	String,  // "quoted"
	Object,  // Class'/Game/P.P'
	Struct,  // (..): named values, elements without names, or none
};

struct FEngineTextItem;

struct FEngineTextValue
{
	EEngineTextKind Kind = EEngineTextKind::Nothing;
	bool Bool = false;
	double Number = 0.0;
	std::string Token;                  // as written; empty for Struct and Nothing
	std::string String;                 // String: without quotes and escapes. Object: the path. Name: the token
	std::vector<FEngineTextItem> Items; // of a Struct
	size_t Offset = 0;                  // where it begins

	/** "True", "a struct", "nothing", ... for messages. */
	DRYDOCK_API std::string Describe() const;
};

/** `Name=Value`, `Name[Index]=Value` or, without a name, the element of an array. */
struct FEngineTextItem
{
	std::string Name;
	int Index = -1; // none
	FEngineTextValue Value;
	size_t Offset = 0; // where it begins

	/** "LensFlareTints[2]" */
	DRYDOCK_API std::string GetKey() const;
};

/** Reads the value that begins at Offset, after spaces and line breaks, and moves Offset behind it. A syntax error is
 * one message; then the result is false and Offset stands where the reader stopped. The text Where names the value in
 * messages.
 * */
DRYDOCK_API bool ParseEngineText(const std::string& Text, size_t& Offset, const std::string& Where,
	FEngineTextValue& OutValue, FSettingsTextMessages& Messages);

/** The same text again, without the spaces between its parts. */
DRYDOCK_API std::string ToEngineText(const FEngineTextValue& Value);

} // namespace Drydock
