// The numbered remarks of the kernel audit. Docs: docs/errors.md.
#pragma once

namespace Drydock
{

enum EKernelAuditError : int
{
	WarnKernelDeclared = 2100, // a faulty kernel that its author declares to be so
	ErrorKernelFaulty = 2101,  // a faulty kernel that nobody declares
};

} // namespace Drydock
