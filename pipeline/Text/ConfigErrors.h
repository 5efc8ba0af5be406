// The numbers of the messages that pipeline/ gives. A number never changes its meaning; docs/errors.md explains each
// one.
#pragma once

#include "Diagnostics.h"

namespace Drydock
{

enum EConfigError
{
	// DD1: config and command line
	ErrorJsonSyntax = 1001,          // not JSON; the rest of the file is not read
	ErrorJsonDepth = 1002,           // nested deeper than any config needs
	ErrorDuplicateKey = 1003,        // one object names a key twice
	ErrorNumberNotFinite = 1004,     // NaN, Infinity, or a number that overflows
	ErrorUnknownKey = 1005,          // no such key in this object
	ErrorWrongType = 1006,           // a value of another JSON type
	ErrorUnknownValue = 1007,        // a text that is none of the allowed ones
	ErrorMissingKey = 1008,          // a key that this object must have
	ErrorWrongLength = 1009,         // an array of another length
	ErrorBadValue = 1010,            // a value that makes no sense there
	WarnOutOfRange = 1011,           // outside the setting's clamps; used as it is
	ErrorUnknownSetting = 1012,      // no such post-process setting
	ErrorUnknownVariable = 1013,     // no such console variable
	ErrorUnknownShowFlag = 1014,     // no such show flag
	WarnNotBuilt = 1015,             // read and valid, but nothing acts on it yet
	WarnInertValue = 1016,           // a value whose override bit is off
	WarnEqualPriority = 1017,        // two volumes of one priority act and disagree: the order of declaration decides
	WarnWeightClamped = 1018,        // a blend weight outside 0..1
	ErrorVolumeWithoutBounds = 1019, // neither bounds nor bUnbound
	ErrorBadArgument = 1020,         // a command-line argument that is not NAME=VALUE and the like
	WarnNothingDumped = 1021,        // a dump pattern that no executed pass or resource matches
	WarnIneffectiveValue = 1022,     // a console variable that nothing reads, a value without effect, a set kept out

	NoteBudgetWithoutChoice = 1023, // a budget, and no study to choose by
	WarnInputsChanged = 1026,       // what a run depended on is different when it is repeated

	WarnNoLocation = 1041,        // bounded volumes, and no location for the view
	ErrorNothingFromScene = 1042, // "fromScene", and no scene or none that suggests anything
	WarnSuggestionLeftOut = 1043, // something that a scene suggests and that does not exist here

	// DD3: settings
	WarnNonFiniteSetting = 3101, // a source's value is NaN or infinite; it does not enter the blend

	// DD4: numbers
	WarnNonFinite = 4001,       // NaN or infinity in an image
	ErrorNonFinite = 4002,      // the same, with r.Drydock.NonFinite 2
	WarnNonFiniteSpread = 4003, // where those of the scene went
	WarnNothingMetered = 4005,  // automatic exposure, and every pixel is darker than what the histogram counts
	WarnCheck = 4010,           // a line of a shader does what --check looks for
	WarnNothingPrinted = 4012,  // --print, and no shader that ran prints

	// DD5: files
	ErrorFileMissing = 5001,    // cannot be opened
	ErrorImageBroken = 5002,    // not an image, truncated or corrupt
	ErrorChannelMissing = 5003, // the scene file lacks a channel that a surviving pass needs
	ErrorFileNotWritten = 5004, // cannot be written
	ErrorImageTooLarge = 5005,  // larger than any frame
	ErrorImagesDiffer = 5006,   // two images of different kinds or sizes cannot be compared
	ErrorStackTooSmall = 5009,  // ulimit -s
	ErrorNotBlessed = 5036,     // a baseline without a record, or of which a file is not the recorded one
	ErrorColorCube = 5035,      // not a .cube file, or not a table of three dimensions

	// DD6: shaders
	WarnDebug = 6060, // --debug-shaders: a shader that no debugger can be given, or no debugger
};

/** The error of a wrong argument of the command line, of the option that Where names. */
inline FError BadArgument(const std::string& Message, const std::string& Where = {})
{
	return FError({.Code = ErrorBadArgument, .Message = Message, .Where = Where}, ExitUsage);
}

} // namespace Drydock
