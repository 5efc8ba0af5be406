// The numbers of the messages of `drydock build`. docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum EPluginBuildError
{
	ErrorNoPlugin = 1100,            // a folder that is none, or has nothing of a plugin in it
	ErrorBuildTools = 1101,          // no cmake, or drydock's own package is not where it belongs
	ErrorPluginNotConfigured = 1102, // cmake refused the plugin
	ErrorPluginNotCompiled = 1103,   // the compiler or the linker did
};

} // namespace Drydock
