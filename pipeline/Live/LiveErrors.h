// The numbers of the messages of `drydock live`. A number never changes its meaning; docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum ELiveError
{
	ErrorBadEdit = 1120,    // an edit, or another request of the page, that is not as it has to be
	ErrorSavePlace = 1121,  // a config is to be saved where it must not
	ErrorBadRecord = 1122,  // --replay: not the record of a session
	ErrorLiveCrash = 1123,  // a frame ended the process that ran it; it was started again with the state before
	ErrorFileExists = 1124, // a config is to be saved over a file, and nobody confirmed it
	ErrorNoServer = 5040,   // the port is taken, or the module that speaks HTTP is missing
};

} // namespace Drydock
