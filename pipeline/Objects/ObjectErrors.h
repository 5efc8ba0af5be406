// The numbers of the messages about values of a plugin's objects and its ini files. A number never changes its meaning;
// docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum EObjectError
{
	ErrorUnknownClass = 2120,     // "objects" names a class that no plugin has
	ErrorUnknownProperty = 2121,  // a class or struct has no such UPROPERTY
	ErrorPropertyValue = 2122,    // a value that the property cannot have
	ErrorPropertyNotGiven = 2123, // a property that cannot be given: an object, an asset, a map, ...
	WarnIniLine = 2124,           // a line of an ini file that is none, or of a form that is left out
	WarnIniFile = 2125,           // an ini file that cannot be read, or is not UTF-8
	WarnIniValue = 2126,          // a class, property or value of an ini file that is not taken
	NoteIniVariable = 2127,       // a console variable of an ini file that drydock and the plugin do not have
	NoteAssetUnused = 2134,       // a render target of "assets" that nothing asks for
};

} // namespace Drydock
