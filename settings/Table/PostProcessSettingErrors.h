// The numbers of the messages about settings that plugins add. A number never changes its meaning; docs/errors.md
// explains each one.
#pragma once

namespace Drydock
{

enum EAddedSettingError
{
	ErrorSettingTaken = 2128,   // a setting of that name is there: drydock's or another plugin's
	ErrorSettingInvalid = 2129, // a name, a range, a default, a blend rule or enum names that make no sense
};

} // namespace Drydock
